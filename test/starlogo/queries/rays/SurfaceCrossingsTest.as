package starlogo.queries.rays
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import support.Complaints;
    import support.Effort;

    /** Crossings in any order, with slacks of all sizes. Real ones are so close to each other by rounding alone. */
    public class SurfaceCrossingsTest
    {
        private static const MOST_SLACKS:Number = 8;

        private var _surfaces:SurfaceCrossings = new SurfaceCrossings();
        private var _random:SeededRandom = new SeededRandom(7403);

        [Test]
        public function trianglesAreInTheOrderOfTheRayAndNoSurfaceIsLost():void
        {
            var wrong:Complaints = new Complaints();
            var joined:int = 0;
            var count:int = Effort.choose(5000, 100000, 500);
            for (var i:int = 0; i < count; i++)
            {
                var crossings:RayCrossings = new RayCrossings();
                var all:Array = [];
                for (var k:int = _random.integer(1, 6); k > 0; k--)
                {
                    var crossing:RayCrossing = crossings.add();
                    crossing.distance = _random.integer(0, 9);
                    crossing.rounding = _random.pick([0, 0.5, 1, 2]);
                    crossing.end = crossing.distance + _random.integer(0, 3);
                    crossing.side = _random.pick([RayCrossing.ENTERS, RayCrossing.LEAVES, RayCrossing.ENTERS, RayCrossing.LEAVES, RayCrossing.EDGE_ON]);
                    all.push(crossing.distance + " with " + crossing.rounding + " from " + crossing.side);
                }
                _surfaces.findOfTriangles(crossings);
                joined += crossings.count - _surfaces.indices.count;
                var said:String = "crossings " + i + ": " + all.join() + ", left " + _surfaces.indices.values.slice(0, _surfaces.indices.count).join();
                wrong.addIf(!areInOrder(crossings), "the order", said);
                for (k = 0; k < crossings.count; k++)
                {
                    wrong.addIf(!isThere(crossings, k), "what is left out", said);
                }
            }
            wrong.assertNone();
            assertTrue(joined + " joined", joined > count / 2);
        }

        /** A node that the ray enters within rounding after it has begun inside of another is no second surface there. */
        [Test]
        public function whereTheRayBeginsInsideIsOneSurface():void
        {
            var crossings:RayCrossings = new RayCrossings();
            var sides:Array = [RayCrossing.INSIDE, RayCrossing.ENTERS, RayCrossing.ENTERS, RayCrossing.LEAVES, RayCrossing.LEAVES, RayCrossing.ENTERS];
            var distances:Array = [0, 0, 0.5, 5, 6, 8];
            for (var i:int = 0; i < sides.length; i++)
            {
                var crossing:RayCrossing = crossings.add();
                crossing.distance = distances[i];
                crossing.rounding = i < 2 ? 0 : 1;
                crossing.side = sides[i];
            }
            _surfaces.findOfSolids(crossings);
            assertEquals("0,4,5", _surfaces.indices.values.slice(0, _surfaces.indices.count).join());
        }

        private function areInOrder(crossings:RayCrossings):Boolean
        {
            for (var i:int = 1; i < _surfaces.indices.count; i++)
            {
                if (!(crossings.items[_surfaces.indices.values[i]].distance >= crossings.items[_surfaces.indices.values[i - 1]].distance) || _surfaces.indices.values[i] == _surfaces.indices.values[i - 1])
                {
                    return false;
                }
            }
            return _surfaces.indices.count > 0;
        }

        // Whether a crossing is left, or one that may be of the same surface: not farther away than some slacks, and not seen from the other side.
        private function isThere(crossings:RayCrossings, index:int):Boolean
        {
            for (var i:int = 0; i < _surfaces.indices.count; i++)
            {
                var other:int = _surfaces.indices.values[i];
                var isNear:Boolean = Math.abs(crossings.items[other].distance - crossings.items[index].distance) <= MOST_SLACKS;
                var runsAlong:Boolean = crossings.items[other].side == RayCrossing.EDGE_ON || crossings.items[index].side == RayCrossing.EDGE_ON;
                if (crossings.items[other].side == crossings.items[index].side ? isNear || runsAlong : isNear && runsAlong)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
