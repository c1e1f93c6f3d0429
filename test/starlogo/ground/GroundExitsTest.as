package starlogo.ground
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.ContactPoint;
    import support.Complaints;

    /** How long exits from the ground are at least, beside a search of many. */
    public class GroundExitsTest
    {
        private static const WIDTH:Number = 0.5;
        private static const SIDE:int = 9;

        private var _random:SeededRandom = new SeededRandom(703);
        private var _wrong:Complaints = new Complaints();
        private var _exits:GroundExits = new GroundExits();
        private var _contact:ContactPoint = new ContactPoint();

        [Test]
        public function noExitIsShorterThanTheBound():void
        {
            var known:int = 0;
            var count:int = 3000;
            for (var i:int = 0; i < count; i++)
            {
                var grid:HeightGrid = randomGrid();
                var x:Number = _random.between(-2, 2);
                var y:Number = _random.between(-2, 2);
                var z:Number = grid.heightAt(x, y) - _random.logBetween(0.001, 2);
                var reach:Number = _random.logBetween(0.01, 3);
                var least:Number = boundAt(grid, x, y, z, reach);
                _wrong.addIf(!(least >= 0), "negative", i + ": " + least);
                known += least > 0 ? 1 : 0;
                for (var k:int = 0; k < 20 && least > 0; k++)
                {
                    // a random direction, a little shorter
                    var up:Number = _random.between(-1, 1);
                    var turn:Number = _random.between(0, 2 * Math.PI);
                    var length:Number = 0.999999 * Math.min(least, reach);
                    var across:Number = length * Math.sqrt(1 - up * up);
                    var height:Number = grid.heightAt(x + across * Math.cos(turn), y + across * Math.sin(turn));
                    _wrong.addIf(!(height >= z + length * up), "shorter", i + ": " + length + " of " + least);
                }
            }
            _wrong.assertNone();
            assertTrue(known + " of " + count, known > count / 4 && known < count);
        }

        // At a border between columns the ground ends beside a point that is higher than the lower column, and at the border of the grid it ends too.
        [Test]
        public function atABorderOfColumnsThereIsAnExitOfNoLength():void
        {
            var grid:HeightGrid = new HeightGrid(SIDE, SIDE, WIDTH, -2, -2);
            grid.isBlocky = true;
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < SIDE * SIDE; i++)
            {
                heights.push(i % SIDE > 1 ? 0 : 1);
            }
            grid.setHeights(0, 0, SIDE, SIDE, heights);
            var border:Number = -2 + 1.5 * WIDTH;
            for each (var reach:Number in [1e-20, 1e-9, 0.01, 1])
            {
                assertEquals("between columns, " + reach, 0, boundAt(grid, border, 0, 0.5, reach));
                assertEquals("at the end, " + reach, 0, boundAt(grid, -2 - WIDTH / 2, 0, 0.5, reach));
                assertEquals("inside, " + reach, reach < 0.1 ? 0.5 : 0, boundAt(grid, border - WIDTH / 3, 0, 0.5, reach));
            }
        }

        // The bound for the deepest point of a contact, which is half of the depth below the contact's point.
        private function boundAt(grid:HeightGrid, x:Number, y:Number, z:Number, reach:Number):Number
        {
            _contact.depth = 0.5;
            _contact.x = x;
            _contact.y = y;
            _contact.z = z + 0.25;
            return _exits.boundOf(grid, _contact, reach);
        }

        private function randomGrid():HeightGrid
        {
            var grid:HeightGrid = new HeightGrid(SIDE, SIDE, WIDTH, -2, -2);
            grid.isBlocky = _random.chance();
            var high:Number = _random.pick([0.02, 0.3, 3]);
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < SIDE * SIDE; i++)
            {
                heights.push(_random.between(0, high));
            }
            grid.setHeights(0, 0, SIDE, SIDE, heights);
            return grid;
        }
    }
}
