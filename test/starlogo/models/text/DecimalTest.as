package starlogo.models.text
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Fixtures;

    public class DecimalTest
    {
        // Words and the bits of their numbers, which test/oracle/decimals.py has made.
        private static const VECTORS:String = "/fixtures/decimals.txt";

        public static const FIXTURES:Array = [VECTORS];

        [Test]
        public function everyNumberIsTheNearest():void
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            var lines:Array = Fixtures.text(VECTORS).split("\n");
            assertEquals(2401, lines.length);
            for each (var line:String in lines.slice(0, 2400))
            {
                var parts:Array = line.split(" ");
                bytes.position = 0;
                bytes.writeDouble(Decimal.of(parts[0]));
                bytes.position = 0;
                assertEquals(parts[0], parts[1], hexadecimal(bytes.readUnsignedInt()) + hexadecimal(bytes.readUnsignedInt()));
            }
        }

        [Test]
        public function largeSmallAndNone():void
        {
            for each (var zero:String in ["0", "-0", "0.0", "0.00000000000000000000", "1e-400", "1e-99999999999", "0e999999"])
            {
                assertTrue(zero, Decimal.of(zero) == 0);
            }
            assertTrue("-0", 1 / Decimal.of("-0") < 0 && 1 / Decimal.of("-0.00000000000000000000") < 0);
            for each (var large:String in ["1e309", "1e99999999999", "12345678901234567890e300"])
            {
                assertEquals(large, Infinity, Decimal.of(large));
                assertEquals(large, -Infinity, Decimal.of("-" + large));
            }
            for each (var wrong:String in [null, "", " ", ".", "-", "+", "e5", ".e5", "1e", "1e+", "1e-", "1.2.3", "--1", "1x", "Infinity", "NaN",
                        "1,2,3", "1,2.3", "1.2,3", ",", "10e", "10e+", "1x0", "10.e", "1.234567890123456789e", "1.234567890123456789-", "- 1.2345678901234567", "0x10", "0X1", "-0x10", "+0x1", "0b11", "0o17", "\u00A01", "\f1", "\v1",
                        "\uFEFF1", "1\u00A0", "1\f2", "0x", "0x1234567890123456", "1_0", "\u0661"])
            {
                assertTrue(wrong, isNaN(Decimal.of(wrong)));
            }
        }

        [Test]
        public function takesADecimalComma():void
        {
            assertEquals(2.5, Decimal.of("2,5"));
            assertEquals(-0.25, Decimal.of("-,25"));
            assertEquals(Decimal.of("1234567.890123456789e-5"), Decimal.of("1234567,890123456789e-5"));
        }

        [Test]
        public function wrongWordsAreFoundInLinearTime():void
        {
            for each (var digits:String in ["0", "9", "0.", "00000000.0", "-"])
            {
                var word:String = new Array(20001).join(digits);
                for each (var end:String in ["x", "e", "e+", ".x", "e1x", "."])
                {
                    assertTrue(digits + end, isNaN(Decimal.of(word + "." + word + end)));
                }
            }
            assertEquals(0.1, Decimal.of("." + new Array(3).join("0").substr(2) + "1" + new Array(9001).join("0")));
        }

        private static function hexadecimal(word:uint):String
        {
            return ("0000000" + word.toString(16)).slice(-8);
        }
    }
}
