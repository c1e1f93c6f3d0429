package starlogo.models
{
    /**
     * Where in a text the next of two characters is, for a walk through the text that never goes back: each character is looked for
     * anew only when the walk has passed it.
     *
     * @private
     */
    public final class NextOfTwo
    {
        private var _text:String;
        private var _first:String;
        private var _second:String;
        private var _firstAt:int = -1;
        private var _secondAt:int = -1;

        /**
         * @param text the text
         * @param first a character
         * @param second another one
         */
        public function NextOfTwo(text:String, first:String, second:String)
        {
            _text = text;
            _first = first;
            _second = second;
        }

        /** The first place at or after another that has one of the two; the text's length if none has. */
        public function after(place:int):int
        {
            if (_firstAt < place)
            {
                _firstAt = placeOf(_first, place);
            }
            if (_secondAt < place)
            {
                _secondAt = placeOf(_second, place);
            }
            return _firstAt < _secondAt ? _firstAt : _secondAt;
        }

        private function placeOf(character:String, from:int):int
        {
            var place:int = _text.indexOf(character, from);
            return place < 0 ? _text.length : place;
        }
    }
}
