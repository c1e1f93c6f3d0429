package starlogo.models.gltf
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import starlogo.models.ModelError;
    import starlogo.steps.finish;
    import support.assertThrows;

    /** Bytes as text of base64. */
    public class DecodingBase64Test
    {
        private static const DIGITS:String = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

        /** Only the digits count, and those that addresses use in place of two of them. */
        [Test]
        public function anyOtherCharacterIsRefused():void
        {
            for (var code:int = 0; code < 300; code++)
            {
                var character:String = String.fromCharCode(code);
                var text:String = "AA" + character + "A";
                if ((DIGITS + "-_").indexOf(character) >= 0)
                {
                    assertEquals(character, 3, decoded(text).length);
                }
                else
                {
                    assertThrows(ModelError, /expected base64, but found other characters/, decoded, text);
                }
            }
        }

        [Test]
        public function bytesAreAsTheyWere():void
        {
            var random:SeededRandom = new SeededRandom(64);
            for (var length:int = 0; length < 40; length++)
            {
                var bytes:Array = [];
                for (var i:int = 0; i < length; i++)
                {
                    bytes.push(random.integer(0, 255));
                }
                for each (var ending:String in ["", "=="])
                {
                    var found:ByteArray = decoded(encoded(bytes) + ending.substr(0, (3 - length % 3) % 3));
                    var values:Array = [];
                    for (i = 0; i < found.length; i++)
                    {
                        values.push(found[i]);
                    }
                    assertEquals(bytes.join(), values.join());
                }
            }
        }

        private static function decoded(text:String):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            finish(decodingBase64("model", text, 0, "buffer 0", bytes));
            return bytes;
        }

        // Six bits after the other. The last digit has zeros after the last bits.
        private static function encoded(bytes:Array):String
        {
            var text:String = "";
            for (var bit:int = 0; bit < 8 * bytes.length; bit += 6)
            {
                var pair:int = bytes[bit >> 3] << 8 | int(bytes[(bit >> 3) + 1]);
                text += DIGITS.charAt(pair >> 10 - (bit & 7) & 63);
            }
            return text;
        }
    }
}
