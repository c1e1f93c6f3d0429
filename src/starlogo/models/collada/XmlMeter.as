package starlogo.models.collada
{
    import starlogo.models.NextOfTwo;
    import starlogo.models.refuseIf;
    import starlogo.steps.Steps;

    /**
     * Looks through XML before it is parsed, for what players take long over: they parse in one piece, and in a time that goes with the
     * square of how deep elements are nested and of how many attributes one has.
     */
    internal final class XmlMeter implements Steps
    {
        /** How deep elements may be nested. */
        internal static const MAX_DEPTH:int = 1000;

        /** How many attributes an element may have. */
        internal static const MAX_ATTRIBUTES:int = 100;

        /** How many elements there may be. */
        internal static const MAX_ELEMENTS:int = 500000;

        private static const TAGS_PER_STEP:int = 2000;
        private static const EXCLAMATION:int = 0x21;
        private static const QUESTION:int = 0x3F;
        private static const SLASH:int = 0x2F;

        private var _name:String;
        private var _source:String;
        private var _at:int = 0;
        private var _depth:int = 0;
        private var _elements:int = 0;

        private var _quotes:NextOfTwo;

        /**
         * @param name the model's name
         * @param source the text
         */
        public function XmlMeter(name:String, source:String)
        {
            _name = name;
            _source = source;
            _quotes = new NextOfTwo(source, "\"", "'");
        }

        /**
         * @inheritDoc What is not well-formed is left to the parser.
         *
         * @throws ModelError if there is too much of something
         */
        public function step():Boolean
        {
            for (var i:int = 0; i < TAGS_PER_STEP && _at >= 0; i++)
            {
                _at = _source.indexOf("<", _at);
                if (_at >= 0)
                {
                    passTag();
                }
            }
            return _at >= 0;
        }

        private function passTag():void
        {
            switch (_source.charCodeAt(_at + 1))
            {
                case EXCLAMATION:
                    passDeclaration();
                    break;
                case QUESTION:
                    pass("?>");
                    break;
                case SLASH:
                    _depth--;
                    pass(">");
                    break;
                default:
                    passElement();
            }
        }

        private function passDeclaration():void
        {
            var start:String = _source.substr(_at, 9);
            pass(start.indexOf("<!--") == 0 ? "-->" : start == "<![CDATA[" ? "]]>" : ">");
        }

        private function passElement():void
        {
            refuseIf(++_elements > MAX_ELEMENTS, _name, "the document has more than " + MAX_ELEMENTS + " elements");
            var end:int = _source.indexOf(">", _at);
            var attributes:int = 0;
            for (var quote:int = _quotes.after(_at); quote < end; quote = _quotes.after(_at))
            {
                refuseIf(++attributes > MAX_ATTRIBUTES, _name, "the document has an element of more than " + MAX_ATTRIBUTES + " attributes");
                var close:int = _source.indexOf(_source.charAt(quote), quote + 1);
                _at = close + 1;
                end = close < 0 ? -1 : end < close ? _source.indexOf(">", _at) : end;
            }
            if (end >= 0 && _source.charCodeAt(end - 1) != SLASH)
            {
                refuseIf(++_depth > MAX_DEPTH, _name, "the document has elements that are nested more than " + MAX_DEPTH + " deep");
            }
            _at = end;
        }

        // Goes to the end of something, or to that of the text.
        private function pass(end:String):void
        {
            _at = _source.indexOf(end, _at);
        }
    }
}
