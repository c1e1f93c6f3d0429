package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /** Decodes base64 text (RFC 4648), in steps. */
    internal final class Base64 extends StepSequence
    {
        private static const CHARACTERS_PER_STEP:int = 16000;
        private static const DIGITS:String = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

        private static var sValues:Vector.<int> = valuesOfDigits();

        /** The bytes decoded so far. All of them when no step is left. */
        public var bytes:ByteArray = new ByteArray();

        private var _name:String;
        private var _text:String;
        private var _place:String;
        private var _start:int;

        /**
         * @param name the model's name
         * @param text contains the digits
         * @param start the place of the first digit in the text
         * @param place the place in the file, for errors
         */
        public function Base64(name:String, text:String, start:int, place:String)
        {
            _name = name;
            _text = text;
            _start = start;
            _place = place;
            var end:int = text.length;
            while (end > start && end > text.length - 2 && text.charAt(end - 1) == "=")
            {
                end--;
            }
            refuseIf((end - start) % 4 == 1, name, "its base64 is cut off", place);
            bytes.length = (end - start) * 3 >> 2;
            slices(end - start, CHARACTERS_PER_STEP, decode);
        }

        // Each step begins with a group of four digits, because the number of digits per step is a multiple of four.
        private function decode(first:int, end:int):void
        {
            var values:Vector.<int> = sValues;
            var out:ByteArray = bytes;
            var at:int = first * 3 >> 2;
            var wrong:int = 0;
            var bits:int = 0;
            var bitCount:int = 0;
            for (var i:int = first; i < end; i++)
            {
                var code:int = _text.charCodeAt(_start + i);
                var value:int = code < 128 ? values[code] : -1;
                wrong |= value;
                bits = bits << 6 | value;
                bitCount += 6;
                if (bitCount >= 8)
                {
                    bitCount -= 8;
                    out[at++] = bits >> bitCount & 255;
                }
            }
            refuseIf(wrong < 0, _name, "expected base64, but found other characters", _place);
        }

        private static function valuesOfDigits():Vector.<int>
        {
            var values:Vector.<int> = new Vector.<int>(128);
            for (var i:int = 0; i < 128; i++)
            {
                values[i] = DIGITS.indexOf(String.fromCharCode(i));
            }
            // the digits that addresses use instead of + and /
            values[0x2D] = 62;
            values[0x5F] = 63;
            return values;
        }
    }
}
