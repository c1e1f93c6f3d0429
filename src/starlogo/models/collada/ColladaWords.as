package starlogo.models.collada
{
    import starlogo.models.text.TextWords;
    import starlogo.steps.Steps;

    /** The words in the own texts of some elements, one after the other, in steps. */
    internal final class ColladaWords implements Steps
    {
        private static const CHARACTERS_PER_STEP:int = 200000;
        private static const SPACE:int = 0x20;

        /** The words, when no step is left. */
        public var words:Array = [];

        // the text, and the start of its next piece
        private var _text:String;
        private var _start:int = 0;

        /**
         * @param elements the elements to read
         */
        public function ColladaWords(elements:Vector.<ColladaElement>)
        {
            var texts:Array = [];
            for each (var element:ColladaElement in elements)
            {
                texts.push(element.texts.join(" "));
            }
            _text = texts.join(" ");
        }

        /** The number of characters of the texts. */
        public function get length():int
        {
            return _text.length;
        }

        /** @inheritDoc Reads a piece of the text. It does not split words. */
        public function step():Boolean
        {
            var end:int = Math.min(_start + CHARACTERS_PER_STEP, _text.length);
            while (end < _text.length && _text.charCodeAt(end) > SPACE)
            {
                end++;
            }
            var more:Array = TextWords.of(_text.substring(_start, end));
            // most texts are one piece, whose list is taken as it is
            for (var i:int = 0; i < more.length && _start > 0; i++)
            {
                words.push(more[i]);
            }
            words = _start == 0 ? more : words;
            _start = end;
            return _start < _text.length;
        }
    }
}
