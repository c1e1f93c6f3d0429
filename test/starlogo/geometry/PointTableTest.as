package starlogo.geometry
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;

    public class PointTableTest
    {
        [Test]
        public function eachPlaceIsThereOnce():void
        {
            var random:SeededRandom = new SeededRandom(5);
            var table:PointTable = new PointTable(3375);
            var numbers:Object = {};
            var count:int = 0;
            for (var i:int = 0; i < 5000; i++)
            {
                // a grid of 3,375 places: many come again
                var x:Number = random.integer(-7, 7) * 0.1;
                var y:Number = random.integer(-7, 7) * 1e-9;
                var z:Number = random.integer(-7, 7) * 1e9;
                var place:String = [x, y, z].join();
                if (!numbers.hasOwnProperty(place))
                {
                    numbers[place] = count++;
                    assertEquals(3 * (count - 1), table.coordinates.length);
                }
                assertEquals(numbers[place], table.indexOf(x, y, z));
            }
            assertEquals(3 * count, table.coordinates.length);
        }

        [Test]
        public function neighboursAreTwo():void
        {
            var table:PointTable = new PointTable(3);
            assertEquals(0, table.indexOf(1, 2, 3));
            assertEquals(1, table.indexOf(1 + 2.220446049250313e-16, 2, 3));
            assertEquals(2, table.indexOf(2, 1, 3));
            assertEquals(0, table.indexOf(1, 2, 3));
        }

        [Test]
        public function zeroHasNoSign():void
        {
            var table:PointTable = new PointTable(1);
            assertEquals(0, table.indexOf(0, 0, 0));
            assertEquals(0, table.indexOf(-0, 0 * -1, -0));
        }

        [Test]
        public function aFullTableStillFinds():void
        {
            for (var most:int = 1; most <= 9; most++)
            {
                var table:PointTable = new PointTable(most);
                for (var again:int = 0; again < 2; again++)
                {
                    for (var i:int = 0; i < most; i++)
                    {
                        assertEquals(i, table.indexOf(i, 0, 0));
                    }
                }
            }
        }
    }
}
