package starlogo.models.gltf
{
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Measures JSON before the player parses it, in steps: parsers descend into what is nested, and make an object of every value. */
    internal final class JsonMeter extends StepSequence
    {
        internal static const MAX_DEPTH:int = 100;
        internal static const MAX_VALUES:int = 2000000;

        private static const CHARACTERS_PER_STEP:int = 8000;

        private static const QUOTE:int = 0x22;
        private static const BACKSLASH:int = 0x5C;
        private static const COMMA:int = 0x2C;

        private var _name:String;
        private var _text:String;
        private var _next:int = 0;
        private var _depth:int = 0;
        private var _values:int = 0;

        /**
         * @param name the model's name
         * @param text JSON, or what may be
         */
        public function JsonMeter(name:String, text:String)
        {
            _name = name;
            _text = text;
            repeat(measure);
        }

        private function measure():Boolean
        {
            var text:String = _text;
            var length:int = text.length;
            var last:int = Math.min(_next + CHARACTERS_PER_STEP, length);
            var i:int = _next;
            while (i < last)
            {
                var code:int = text.charCodeAt(i);
                i = code == QUOTE ? endOfString(i + 1) : i + 1;
                if (code == 0x7B || code == 0x5B)
                {
                    _depth++;
                    _values++;
                    refuseIf(_depth > MAX_DEPTH, _name, "its JSON is nested deeper than " + MAX_DEPTH, "character " + i);
                }
                else if (code == 0x7D || code == 0x5D)
                {
                    _depth--;
                }
                else if (code == COMMA)
                {
                    _values++;
                }
            }
            _next = i;
            refuseIf(_values > MAX_VALUES, _name, "its JSON has more than " + MAX_VALUES + " values");
            return _next < length;
        }

        // The place behind the quote that ends a string.
        private function endOfString(from:int):int
        {
            var end:int = _text.indexOf("\"", from);
            while (end >= 0)
            {
                var escape:int = end;
                while (escape > from && _text.charCodeAt(escape - 1) == BACKSLASH)
                {
                    escape--;
                }
                if ((end - escape & 1) == 0)
                {
                    return end + 1;
                }
                end = _text.indexOf("\"", end + 1);
            }
            return _text.length;
        }
    }
}
