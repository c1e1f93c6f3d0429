package starlogo.models.gltf
{
    import starlogo.models.FileLimits;
    import starlogo.models.ModelError;
    import starlogo.models.refuseIf;
    import starlogo.models.text.Decimal;
    import starlogo.steps.Steps;

    /**
     * Reads through JSON before the player parses it, in steps. It checks the size and the brackets, because parsers are recursive, so deep nesting
     * could overflow the stack, and because they create an object for every value. It also marks the numbers that players parse differently: they
     * become strings, and restored() gives their values.
     */
    internal final class JsonScanner implements Steps
    {
        internal static const MAX_DEPTH:int = 100;

        // a value takes a quarter of the memory of an element
        private static const THINGS_PER_VALUE:Number = 0.25;

        // Ruffle's parser keeps whole numbers within 32 bits. In long numbers players differ in the last bits.
        private static const LONGEST_NUMBER:int = 9;
        private static const NUMBER:RegExp = /^-?(0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?$/;
        private static const MARK:String = "\uE002";

        private static const CHARACTERS_PER_STEP:int = 8000;

        private static const QUOTE:int = 0x22;
        private static const BACKSLASH:int = 0x5C;
        private static const PLUS:int = 0x2B;
        private static const COMMA:int = 0x2C;
        private static const SMALL_E:int = 0x65;
        private static const LARGE_E:int = 0x45;

        private var _text:String;
        private var _next:int = 0;
        private var _depth:int = 0;
        private var _limits:FileLimits;

        // The text with its marked numbers, in pieces. They end at a place of the text; 0 if no number is marked yet.
        private var _pieces:Array = [];
        private var _taken:int = 0;

        /**
         * @param text possible JSON
         * @param limits limit the values
         */
        public function JsonScanner(text:String, limits:FileLimits)
        {
            _limits = limits;
            _text = text;
        }

        /** The text with its marked numbers, when no step is left. */
        public function get marked():String
        {
            return _taken == 0 ? _text : _pieces.join("") + _text.substr(_taken);
        }

        /** The value that the JSON had: the number of a marked string. Any other value is returned unchanged. */
        public static function restored(value:*):*
        {
            return value is String && value.charAt(0) == MARK ? Decimal.of(value.substr(1)) : value;
        }

        /** @inheritDoc Checks a part of the text. */
        public function step():Boolean
        {
            var text:String = _text;
            var length:int = text.length;
            var last:int = Math.min(_next + CHARACTERS_PER_STEP, length);
            var i:int = _next;
            var values:int = 0;
            while (i < last)
            {
                var code:int = text.charCodeAt(i);
                if (isInNumber(code))
                {
                    i = passNumber(i);
                    continue;
                }
                i = code == QUOTE ? endOfString(i + 1) : i + 1;
                var isOpening:Boolean = code == 0x7B || code == 0x5B;
                if (isOpening || code == 0x7D || code == 0x5D)
                {
                    changeDepth(isOpening ? 1 : -1, i);
                }
                values += isOpening || code == COMMA ? 1 : 0;
            }
            _next = i;
            _limits.count(FileLimits.THINGS, THINGS_PER_VALUE * values, "character " + i);
            refuseIf(_next == length && _depth > 0, _limits.modelName, "its JSON can't be read: it is cut off", "character " + length);
            return _next < length;
        }

        private function changeDepth(more:int, at:int):void
        {
            _depth += more;
            if (_depth < 0 || _depth > MAX_DEPTH)
            {
                throw new ModelError(_limits.modelName, "character " + at, _depth < 0 ? "its JSON can't be read: a bracket closes nothing"
                        : "its JSON is nested deeper than " + MAX_DEPTH);
            }
        }

        // Digits, "-" and ".". The "e" of true and false begins no number.
        private static function isInNumber(code:int):Boolean
        {
            return code > COMMA && code < 0x3A && code != 0x2F;
        }

        // Passes a number, or text that looks like one, and marks a number that players may parse differently. Returns the place after it.
        private function passNumber(from:int):int
        {
            var end:int = from;
            var code:int;
            do
            {
                code = _text.charCodeAt(++end);
            }
            while (isInNumber(code) || code == PLUS || code == SMALL_E || code == LARGE_E);
            var number:String = end - from > LONGEST_NUMBER ? _text.substring(from, end) : "";
            if (NUMBER.test(number))
            {
                _pieces.push(_text.substring(_taken, from), "\"" + MARK + number + "\"");
                _taken = end;
            }
            return end;
        }

        // The place after the quote that ends a string.
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
