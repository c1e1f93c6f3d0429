package starlogo.models.collada
{
    import starlogo.models.NextOfTwo;
    import starlogo.models.TextTokens;
    import starlogo.steps.Steps;

    /** The words of some elements' own texts, one after the other, in steps. */
    internal final class ColladaWords implements Steps
    {
        private static const CHARACTERS_PER_STEP:int = 200000;

        /** The words, when no step is left. */
        public var words:Array = [];

        private var _elements:Vector.<ColladaElement>;
        private var _element:int = 0;
        // the text that is being read, where its next piece begins, and where words end in it
        private var _text:String = null;
        private var _start:int;
        private var _ends:NextOfTwo;

        /**
         * @param elements the elements to read
         */
        public function ColladaWords(elements:Vector.<ColladaElement>)
        {
            _elements = elements;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            for (var read:int = 0; read < CHARACTERS_PER_STEP && _element < _elements.length; read += 100)
            {
                if (_text == null)
                {
                    _text = _elements[_element].text;
                    _start = 0;
                    _ends = new NextOfTwo(_text, " ", "\n");
                }
                read += readPiece();
            }
            return _element < _elements.length;
        }

        // Words stay whole; returns how many characters it had.
        private function readPiece():int
        {
            var end:int = _text.length - _start > CHARACTERS_PER_STEP ? _ends.after(_start + CHARACTERS_PER_STEP) : _text.length;
            add(TextTokens.of(_text.substring(_start, end)));
            var count:int = end - _start;
            _start = end;
            if (end == _text.length)
            {
                _text = null;
                _element++;
            }
            return count;
        }

        private function add(more:Array):void
        {
            if (words.length == 0)
            {
                words = more;
                return;
            }
            for each (var word:String in more)
            {
                words.push(word);
            }
        }
    }
}
