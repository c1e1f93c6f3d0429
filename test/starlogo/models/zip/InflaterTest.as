package starlogo.models.zip
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.models.ModelError;
    import starlogo.steps.finish;
    import support.assertThrows;

    public class InflaterTest
    {
        [Test]
        public function unpacksWhatWasPacked():void
        {
            var random:SeededRandom = new SeededRandom(11);
            var ratios:Object = {few: 0, some: 0, many: 0};
            for (var i:int = 0; i < 200; i++)
            {
                var content:ByteArray = contentOf(random, int(random.logBetween(1, 60000)));
                var packed:ByteArray = deflated(content);
                var ratio:Number = content.length / packed.length;
                assertSame("content " + i, content, unpacked(packed, content.length));
                ratios[ratio < 1.1 ? "few" : ratio < 5 ? "some" : "many"]++;
            }
            assertTrue("of every kind", ratios.few > 20 && ratios.some > 20 && ratios.many > 20);
        }

        [Test]
        public function unpacksManyBlocks():void
        {
            var random:SeededRandom = new SeededRandom(12);
            var all:ByteArray = new ByteArray();
            for (var i:int = 0; i < 12; i++)
            {
                all.writeBytes(contentOf(random, 50000));
            }
            assertSame("all", all, unpacked(deflated(all), all.length));
        }

        [Test]
        public function unpacksBlocksOfEveryKind():void
        {
            assertSame("stored", bytes(7, 8, 9), unpacked(bytes(0x01, 3, 0, 0xFC, 0xFF, 7, 8, 9), 3));
            assertSame("two stored", bytes(7, 8, 9), unpacked(bytes(0x00, 1, 0, 0xFE, 0xFF, 7, 0x01, 2, 0, 0xFD, 0xFF, 8, 9), 3));
            assertSame("stored, empty", bytes(), unpacked(bytes(0x01, 0, 0, 0xFF, 0xFF), 0));
            assertSame("fixed, empty", bytes(), unpacked(bytes(0x03, 0), 0));
            assertSame("fixed, a byte", bytes(0x61), unpacked(bytes(0x4B, 0x04, 0), 1));
        }

        [Test]
        public function whatIsNotPackedIsTakenAsItIs():void
        {
            assertSame("bytes", bytes(7, 8, 9), unpacked(bytes(7, 8, 9), 3, false));
            fails(/2 bytes unpacked, but has more/, bytes(7, 8, 9), 2, false);
            fails(/4 bytes unpacked, but has fewer/, bytes(7, 8, 9), 4, false);
        }

        [Test]
        public function stopsAtItsSize():void
        {
            var zeros:ByteArray = new ByteArray();
            zeros.length = 5000000;
            fails(/1000 bytes unpacked, but has more/, deflated(zeros), 1000);
            fails(/5000001 bytes unpacked, but has fewer/, deflated(zeros), 5000001);
            fails(/fewer/, deflated(zeros), 60000000);
            fails(/2 bytes unpacked, but has more/, bytes(0x01, 3, 0, 0xFC, 0xFF, 7, 8, 9), 2);
        }

        [Test]
        public function saysWhatIsDamaged():void
        {
            fails(/cut off/, bytes(0x01, 3, 0, 0xFC, 0xFF, 7, 8));
            fails(/cut off/, bytes(0x4B, 0x04));
            fails(/two lengths differ/, bytes(0x01, 3, 0, 0xFD, 0xFF, 7, 8, 9));
            fails(/unknown kind/, bytes(0x07, 0, 0, 0));
            fails(/repeats bytes that are not there/, bytes(0x03, 0x02, 0, 0));
        }

        [Test]
        public function whatIsDamagedIsRefusedOrOfItsSize():void
        {
            var random:SeededRandom = new SeededRandom(13);
            var refused:int = 0;
            for (var i:int = 0; i < 1500; i++)
            {
                var content:ByteArray = contentOf(random, int(random.logBetween(10, 3000)));
                var packed:ByteArray = deflated(content);
                packed[random.integer(0, packed.length - 1)] = random.integer(0, 255);
                try
                {
                    assertEquals("damage " + i, content.length, unpacked(packed, content.length).length);
                }
                catch (error:ModelError)
                {
                    refused++;
                }
            }
            assertTrue("some refused: " + refused, refused > 100 && refused < 1400);
        }

        private static function unpacked(packed:ByteArray, size:int, isDeflated:Boolean = true):ByteArray
        {
            var work:Inflater = new Inflater("a", "b.dae", packed, isDeflated, size);
            finish(work);
            return work.content;
        }

        private static function assertSame(what:String, expected:ByteArray, found:ByteArray):void
        {
            assertEquals(what, expected.length, found.length);
            for (var i:int = 0; i < expected.length; i++)
            {
                if (expected[i] != found[i])
                {
                    fail(what + ": byte " + i + " is " + found[i] + ", not " + expected[i]);
                }
            }
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

        private static function fails(message:RegExp, packed:ByteArray, size:int = 3, isDeflated:Boolean = true):void
        {
            assertThrows(ModelError, message, unpacked, packed, size, isDeflated);
        }
    }
}
