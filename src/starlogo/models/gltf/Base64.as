package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Decodes base64 text (RFC 4648), in steps. The player has no decoder of its own. */
    internal final class Base64
    {
        private static const CHARACTERS_PER_STEP:int = 16000;
        private static const DIGITS:String = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        private static const VALUES:Vector.<int> = valuesOfDigits();

        /**
         * The steps that decode a text.
         *
         * @param name the model's name
         * @param text contains the digits
         * @param start the place of the first digit in the text
         * @param place the place in the file, for errors
         * @param out takes the bytes; empty
         */
        internal static function decoding(name:String, text:String, start:int, place:String, out:ByteArray):Steps
        {
            var length:int = text.length - start;
            for (var most:int = 2; length > 0 && most > 0 && text.charAt(start + length - 1) == "="; most--)
            {
                length--;
            }
            refuseModelIf(length % 4 == 1, name, "its base64 is cut off", place);
            out.length = length * 3 >> 2;
            // Each step begins with a group of four digits, because the number of digits per step is a multiple of four.
            return new StepSequence().slices(length, CHARACTERS_PER_STEP, function(first:int, end:int):void
                {
                    refuseModelIf(!decode(text, start + first, start + end, out, first * 3 >> 2), name, "expected base64, but found other characters", place);
                });
        }

        // Returns whether all characters are digits.
        private static function decode(text:String, from:int, end:int, out:ByteArray, at:int):Boolean
        {
            var wrong:int = 0;
            var bits:int = 0;
            var bitCount:int = 0;
            for (var i:int = from; i < end; i++)
            {
                var code:int = text.charCodeAt(i);
                var value:int = code < 128 ? VALUES[code] : -1;
                wrong |= value;
                bits = bits << 6 | value;
                bitCount += 6;
                if (bitCount >= 8)
                {
                    bitCount -= 8;
                    out[at++] = bits >> bitCount & 255;
                }
            }
            return wrong >= 0;
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
