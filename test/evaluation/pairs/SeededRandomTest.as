package evaluation.pairs
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class SeededRandomTest
    {
        [Test]
        public function repeatsWithItsSeed():void
        {
            var a:SeededRandom = new SeededRandom(7);
            var b:SeededRandom = new SeededRandom(7);
            for (var i:int = 0; i < 100; i++)
            {
                assertEquals(a.next(), b.next());
            }
        }

        [Test]
        public function fillsItsRangeEvenly():void
        {
            var random:SeededRandom = new SeededRandom(11);
            var counts:Vector.<int> = new Vector.<int>(10, true);
            for (var i:int = 0; i < 10000; i++)
            {
                counts[random.integer(0, 9)]++;
            }
            for (i = 0; i < 10; i++)
            {
                assertTrue("bucket " + i + ": " + counts[i], counts[i] > 850 && counts[i] < 1150);
            }
        }
    }
}
