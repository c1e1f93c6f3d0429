package starlogo.queries.rays
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RayEntry;
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
                var entry:RayEntry = new RayEntry();
                for (var k:int = _random.integer(1, 6); k > 0; k--)
                {
                    entry.distance = _random.integer(0, 9);
                    crossings.add(entry, _random.pick([0, 0.5, 1, 2]), entry.distance + _random.integer(0, 3), _random.pick([RayCrossings.FRONT, RayCrossings.BACK, RayCrossings.FRONT, RayCrossings.BACK, RayCrossings.EDGE_ON]));
                }
                _surfaces.find(crossings, true);
                joined += crossings.count - _surfaces.indices.count;
                var said:String = "crossings " + i + ": " + crossings.distances.join() + " with " + crossings.roundings.join() + " from " + crossings.sides.join() + ", left "
                    + _surfaces.indices.values.slice(0, _surfaces.indices.count).join();
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
            var entry:RayEntry = new RayEntry();
            var sides:Array = [RayCrossings.INSIDE, RayCrossings.ENTERS, RayCrossings.ENTERS, RayCrossings.LEAVES, RayCrossings.LEAVES, RayCrossings.ENTERS];
            var distances:Array = [0, 0, 0.5, 5, 6, 8];
            for (var i:int = 0; i < sides.length; i++)
            {
                entry.distance = distances[i];
                crossings.add(entry, i < 2 ? 0 : 1, entry.distance, sides[i]);
            }
            _surfaces.find(crossings, false);
            assertEquals("0,4,5", _surfaces.indices.values.slice(0, _surfaces.indices.count).join());
        }

        private function areInOrder(crossings:RayCrossings):Boolean
        {
            for (var i:int = 1; i < _surfaces.indices.count; i++)
            {
                if (!(crossings.distances[_surfaces.indices.values[i]] >= crossings.distances[_surfaces.indices.values[i - 1]]) || _surfaces.indices.values[i] == _surfaces.indices.values[i - 1])
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
                var isNear:Boolean = Math.abs(crossings.distances[other] - crossings.distances[index]) <= MOST_SLACKS;
                var runsAlong:Boolean = crossings.sides[other] == RayCrossings.EDGE_ON || crossings.sides[index] == RayCrossings.EDGE_ON;
                if (crossings.sides[other] == crossings.sides[index] ? isNear || runsAlong : isNear && runsAlong)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
