package starlogo.models.zip
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.steps.finish;
    import support.assertThrows;

    public class DeflateMeterTest
    {
        [Test]
        public function countsWhatInflateMakes():void
        {
            var random:SeededRandom = new SeededRandom(11);
            var ratios:Object = {few: 0, some: 0, many: 0};
            for (var i:int = 0; i < 200; i++)
            {
                var content:ByteArray = contentOf(random, int(random.logBetween(1, 60000)));
                var packed:ByteArray = deflated(content);
                assertEquals("content " + i, content.length, measure(packed));
                var ratio:Number = content.length / packed.length;
                ratios[ratio < 1.1 ? "few" : ratio < 5 ? "some" : "many"]++;
            }
            assertTrue("of every kind", ratios.few > 20 && ratios.some > 20 && ratios.many > 20);
        }

        [Test]
        public function countsManyBlocks():void
        {
            var random:SeededRandom = new SeededRandom(12);
            var all:ByteArray = new ByteArray();
            for (var i:int = 0; i < 12; i++)
            {
                all.writeBytes(contentOf(random, 50000));
            }
            assertEquals(all.length, measure(deflated(all)));
        }

        [Test]
        public function countsBlocksOfEveryKind():void
        {
            assertEquals("stored", 3, measure(bytes(0x01, 3, 0, 0xFC, 0xFF, 7, 8, 9)));
            assertEquals("two stored", 3, measure(bytes(0x00, 1, 0, 0xFE, 0xFF, 7, 0x01, 2, 0, 0xFD, 0xFF, 8, 9)));
            assertEquals("stored, empty", 0, measure(bytes(0x01, 0, 0, 0xFF, 0xFF)));
            assertEquals("fixed, empty", 0, measure(bytes(0x03, 0)));
            assertEquals("fixed, a byte", 1, measure(bytes(0x4B, 0x04, 0)));
        }

        [Test]
        public function stopsAtItsLimit():void
        {
            var zeros:ByteArray = new ByteArray();
            zeros.length = 5000000;
            var meter:DeflateMeter = new DeflateMeter(deflated(zeros), 1000);
            finish(meter);
            assertTrue(meter.size > 1000 && meter.size < 1000 + 259);
        }

        [Test]
        public function saysWhatIsDamaged():void
        {
            fails(/cut off/, bytes(0x01, 3, 0, 0xFC, 0xFF, 7, 8));
            fails(/cut off/, bytes(0x4B, 0x04));
            fails(/uncertain length/, bytes(0x01, 3, 0, 0xFD, 0xFF, 7, 8, 9));
            fails(/unknown kind/, bytes(0x07, 0, 0, 0));
        }

        /** The player goes easy on some damages: it gives what it could unpack. */
        [Test]
        public function neverCountsFewerThanInflateMakes():void
        {
            var random:SeededRandom = new SeededRandom(13);
            var refused:int = 0;
            var equal:int = 0;
            for (var i:int = 0; i < 1500; i++)
            {
                var packed:ByteArray = deflated(contentOf(random, int(random.logBetween(10, 3000))));
                packed[random.integer(0, packed.length - 1)] = random.integer(0, 255);
                var size:Number = sizeOf(packed);
                var inflated:Number = inflatedSize(packed);
                assertTrue("damage " + i + ": " + size + ", " + inflated, size < 0 || size >= inflated);
                refused += size < 0 ? 1 : 0;
                equal += size == inflated ? 1 : 0;
            }
            assertTrue("some refused: " + refused, refused > 100);
            assertTrue("some sound: " + equal, equal > 100);
        }

        private static function sizeOf(packed:ByteArray):Number
        {
            try
            {
                return measure(packed);
            }
            catch (error:ArgumentError)
            {
                return -1;
            }
            return -1;
        }

        private static function inflatedSize(packed:ByteArray):Number
        {
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(packed);
            try
            {
                copy.inflate();
            }
            catch (error:Error)
            {
                return -1;
            }
            return copy.length;
        }

        private static function measure(packed:ByteArray):Number
        {
            var meter:DeflateMeter = new DeflateMeter(packed, 1e9);
            finish(meter);
            return meter.size;
        }

        /** From noise to the same byte again and again. */
        private static function contentOf(random:SeededRandom, count:int):ByteArray
        {
            var content:ByteArray = new ByteArray();
            var variety:int = random.pick([0, 1, 3, 10, 60, 255]);
            var repeats:Boolean = random.chance(0.4);
            while (content.length < count)
            {
                if (repeats && content.length > 10 && random.chance(0.3))
                {
                    var length:int = random.integer(3, Math.min(content.length, 300));
                    var start:int = random.integer(0, content.length - length);
                    for (var i:int = 0; i < length; i++)
                    {
                        content.writeByte(content[start + i]);
                    }
                }
                content.writeByte(random.integer(0, variety));
            }
            return content;
        }

        private static function deflated(content:ByteArray):ByteArray
        {
            var packed:ByteArray = new ByteArray();
            packed.writeBytes(content);
            packed.deflate();
            return packed;
        }

        private static function bytes(...values):ByteArray
        {
            var result:ByteArray = new ByteArray();
            for each (var value:int in values)
            {
                result.writeByte(value);
            }
            return result;
        }

        private static function fails(message:RegExp, packed:ByteArray):void
        {
            assertThrows(ArgumentError, message, measure, packed);
        }
    }
}
