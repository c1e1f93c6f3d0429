package starlogo.geometry
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Fixtures;
    import support.RunningHash;

    public class TrigonometryTest
    {
        // Angles and points with exact results, which test/oracle/trigonometry.py has made.
        private static const VECTORS:String = "/fixtures/trigonometry.bin";

        public static const FIXTURES:Array = [VECTORS];

        [Test]
        public function resultsAreWithinAUnitInTheLastPlace():void
        {
            var bytes:ByteArray = Fixtures.bytes(VECTORS);
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.position = 0;
            var count:int = 0;
            var largest:Vector.<Number> = new Vector.<Number>(3);
            while (bytes.bytesAvailable > 0)
            {
                var angle:Number = bytes.readDouble();
                largest[0] = Math.max(largest[0], errorOf(Trigonometry.sine(angle), bytes));
                largest[1] = Math.max(largest[1], errorOf(Trigonometry.cosine(angle), bytes));
                var y:Number = bytes.readDouble();
                var x:Number = bytes.readDouble();
                largest[2] = Math.max(largest[2], errorOf(Trigonometry.arctangent(y, x), bytes));
                count++;
            }
            assertEquals(3000, count);
            assertTrue("sine " + largest[0], largest[0] > 0.5 && largest[0] < 0.8);
            assertTrue("cosine " + largest[1], largest[1] > 0.5 && largest[1] < 0.8);
            assertTrue("arctangent " + largest[2], largest[2] > 0.45 && largest[2] < 0.51);
        }

        [Test]
        public function resultsAreTheSameOnEveryMachine():void
        {
            var random:SeededRandom = new SeededRandom(2812);
            var hash:RunningHash = new RunningHash();
            for (var i:int = 0; i < 3000; i++)
            {
                var scale:Number = i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 500 : 1e9;
                var y:Number = random.between(-scale, scale);
                var x:Number = random.between(-1, 1);
                hash.addNumber(Trigonometry.sine(y));
                hash.addNumber(Trigonometry.cosine(y));
                hash.addNumber(Trigonometry.arctangent(y, x));
            }
            assertEquals("441f136f", hash.toString());
        }

        [Test]
        public function quarterTurnsAreExact():void
        {
            var sines:Array = [0, 1, 0, -1];
            for (var quarter:int = -9; quarter <= 9; quarter++)
            {
                assertEquals(sines[quarter & 3], Trigonometry.sine(90 * quarter));
                assertEquals(sines[(quarter + 1) & 3], Trigonometry.cosine(90 * quarter));
                assertEquals(sines[quarter & 3], Trigonometry.sine(90 * quarter + 360e9));
            }
            assertEquals(0.5, Trigonometry.sine(30));
            assertEquals(0.5, Trigonometry.cosine(-60));
            assertTrue("not a number", isNaN(Trigonometry.sine(NaN)) && isNaN(Trigonometry.cosine(Infinity)));
        }

        [Test]
        public function arctangentsOfTheEightDirectionsAreExact():void
        {
            var angles:Array = [0, 45, 90, 135, 180, -135, -90, -45];
            var xs:Array = [1, 1, 0, -1, -1, -1, 0, 1];
            var ys:Array = [0, 1, 1, 1, 0, -1, -1, -1];
            for each (var scale:Number in [1, 1e-280, 1e280, 1e-150, 1e150, 3])
            {
                for (var i:int = 0; i < 8; i++)
                {
                    assertEquals(angles[i], Trigonometry.arctangent(scale * ys[i], scale * xs[i]));
                }
            }
            assertEquals(0, Trigonometry.arctangent(0, 0));
        }

        [Test]
        public function arctangentsDoNotDependOnTheScale():void
        {
            var random:SeededRandom = new SeededRandom(2601);
            for (var i:int = 0; i < 500; i++)
            {
                var y:Number = random.between(-1, 1);
                var x:Number = random.between(-1, 1);
                var angle:Number = Trigonometry.arctangent(y, x);
                assertTrue("the quadrant", (angle > 0) == (y > 0) && (Math.abs(angle) < 90) == (x > 0));
                for each (var scale:Number in [Math.pow(2, -600), Math.pow(2, 600), Math.pow(2, 30)])
                {
                    assertTrue(Math.abs(angle - Trigonometry.arctangent(scale * y, scale * x)) <= 1e-15 * Math.abs(angle));
                }
            }
        }

        // In units of the last place of the exact result, which the bytes have as the nearest Number and the rest.
        private static function errorOf(found:Number, bytes:ByteArray):Number
        {
            var nearest:Number = bytes.readDouble();
            var error:Number = Math.abs(found - nearest - bytes.readDouble());
            return error == 0 ? 0 : error / unitOf(Math.abs(nearest));
        }

        private static function unitOf(value:Number):Number
        {
            var unit:Number = 1;
            while (unit > value)
            {
                unit *= 0.5;
            }
            while (2 * unit <= value)
            {
                unit *= 2;
            }
            return unit * Math.pow(2, -52);
        }
    }
}
