package starlogo.data
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class IntSetTest
    {
        [Test]
        public function hasWhatWasAddedSinceItWasEmptied():void
        {
            var random:SeededRandom = new SeededRandom(1129);
            var numbers:IntSet = new IntSet();
            var again:int = 0;
            for (var i:int = 0; i < 50; i++)
            {
                var length:int = random.integer(1, 40);
                var expected:Object = {};
                numbers.clear(length);
                for (var k:int = 0; k < 20; k++)
                {
                    var number:int = random.integer(0, length - 1);
                    assertEquals("is new", !expected[number], numbers.add(number));
                    again += expected[number] ? 1 : 0;
                    expected[number] = true;
                }
                for (number = 0; number < length; number++)
                {
                    assertEquals(number + " of " + length, Boolean(expected[number]), numbers.has(number));
                }
            }
            assertTrue(again + " were there", again > 50 && again < 900);
        }

        [Test]
        public function isEmptyHoweverOftenItWasEmptied():void
        {
            var numbers:IntSet = new IntSet();
            numbers.clear(8);
            numbers.add(3);
            numbers.mark = int.MAX_VALUE;
            numbers.add(5);
            numbers.clear(8);
            assertEquals(1, numbers.mark);
            for (var number:int = 0; number < 8; number++)
            {
                assertTrue(!numbers.has(number) && numbers.add(number));
            }
        }
    }
}
