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
                var crossings:RayCrossings = _surfaces.crossings;
                crossings.count = 0;
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
                _surfaces.findSurfacesOfTriangles();
                joined += crossings.count - _surfaces.count;
                var said:String = "crossings " + i + ": " + all.join() + ", left at " + surfaceDistances().join();
                wrong.addIf(!areInOrder(), "the order", said);
                for (k = 0; k < crossings.count; k++)
                {
                    wrong.addIf(!isThere(crossings.items[k]), "what is left out", said);
                }
            }
            wrong.assertNone();
            assertTrue(joined + " joined", joined > count / 2);
        }

        /** A node that the ray enters within rounding after it has begun inside of another is no second surface there. */
        [Test]
        public function whereTheRayBeginsInsideIsOneSurface():void
        {
            var crossings:RayCrossings = _surfaces.crossings;
            var sides:Array = [RayCrossing.INSIDE, RayCrossing.ENTERS, RayCrossing.ENTERS, RayCrossing.LEAVES, RayCrossing.LEAVES, RayCrossing.ENTERS];
            var distances:Array = [0, 0, 0.5, 5, 6, 8];
            for (var i:int = 0; i < sides.length; i++)
            {
                var crossing:RayCrossing = crossings.add();
                crossing.distance = distances[i];
                crossing.rounding = i < 2 ? 0 : 1;
                crossing.side = sides[i];
            }
            _surfaces.findSurfacesOfParts();
            assertEquals("0,6,8", surfaceDistances().join());
        }

        private function surfaceDistances():Array
        {
            var found:Array = [];
            for (var i:int = 0; i < _surfaces.count; i++)
            {
                found.push(_surfaces.surfaceAt(i).distance);
            }
            return found;
        }

        private function areInOrder():Boolean
        {
            for (var i:int = 1; i < _surfaces.count; i++)
            {
                var before:RayCrossing = _surfaces.surfaceAt(i - 1);
                if (!(_surfaces.surfaceAt(i).distance >= before.distance) || _surfaces.surfaceAt(i) === before)
                {
                    return false;
                }
            }
            return _surfaces.count > 0;
        }

        // Whether a crossing is left, or one that may be of the same surface: not farther away than some slacks, and not seen from the other side.
        private function isThere(crossing:RayCrossing):Boolean
        {
            for (var i:int = 0; i < _surfaces.count; i++)
            {
                var other:RayCrossing = _surfaces.surfaceAt(i);
                var isNear:Boolean = Math.abs(other.distance - crossing.distance) <= MOST_SLACKS;
                var runsAlong:Boolean = other.side == RayCrossing.EDGE_ON || crossing.side == RayCrossing.EDGE_ON;
                if (other.side == crossing.side ? isNear || runsAlong : isNear && runsAlong)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
