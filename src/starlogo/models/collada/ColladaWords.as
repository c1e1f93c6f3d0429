package starlogo.models.collada
{
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
        // the text that is being read, where its next piece begins, and the white space next to each piece's end
        private var _text:String = null;
        private var _start:int;
        private var _space:int;
        private var _lineEnd:int;

        /**
         * @param elements whose words they are
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
                    _space = _lineEnd = -1;
                }
                read += readPiece();
            }
            return _element < _elements.length;
        }

        // How many characters it had.
        private function readPiece():int
        {
            var end:int = endOfPiece(_start + CHARACTERS_PER_STEP);
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

        // Words stay whole.
        private function endOfPiece(from:int):int
        {
            if (from >= _text.length)
            {
                return _text.length;
            }
            if (_space < from)
            {
                _space = placeOf(" ", from);
            }
            if (_lineEnd < from)
            {
                _lineEnd = placeOf("\n", from);
            }
            return Math.min(_space, _lineEnd);
        }

        private function placeOf(what:String, from:int):int
        {
            var place:int = _text.indexOf(what, from);
            return place < 0 ? _text.length : place;
        }
    }
}
