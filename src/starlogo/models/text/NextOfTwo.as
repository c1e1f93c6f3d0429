package starlogo.models.text
{
    /**
     * Finds the next of two characters in a text, for a loop that only moves forward. It searches for each character again only after the
     * loop has passed the last place found.
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
         * @param first one character
         * @param second the other character
         */
        public function NextOfTwo(text:String, first:String, second:String)
        {
            _text = text;
            _first = first;
            _second = second;
        }

        /** The first place of either character at or after the given place; the text's length if there is none. */
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
