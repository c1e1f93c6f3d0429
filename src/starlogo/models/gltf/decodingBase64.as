package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The steps that decode base64 text (RFC 4648). The player has no decoder of its own. The digits of addresses, "-" and "_", count too.
     *
     * @param name the model's name
     * @param text contains the digits
     * @param start the place of the first digit in the text
     * @param place the place in the file, for errors
     * @param out takes the bytes; empty
     *
     * @private
     */
    internal function decodingBase64(name:String, text:String, start:int, place:String, out:ByteArray):Steps
    {
        const CHARACTERS_PER_STEP:int = 16000;
        const DIGITS:String = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        var values:Vector.<int> = new Vector.<int>(128);
        for (var i:int = 0; i < 128; i++)
        {
            values[i] = DIGITS.indexOf(String.fromCharCode(i));
        }
        values[0x2D] = 62;
        values[0x5F] = 63;
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
                var at:int = first * 3 >> 2;
                var wrong:int = 0;
                var bits:int = 0;
                var bitCount:int = 0;
                for (var k:int = start + first; k < start + end; k++)
                {
                    var code:int = text.charCodeAt(k);
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
                refuseModelIf(wrong < 0, name, "expected base64, but found other characters", place);
            });
    }
}
