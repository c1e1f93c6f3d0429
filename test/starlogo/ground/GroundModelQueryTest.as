package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;
    import support.RandomGround;

    use namespace engine;

    /** A sweep of a model and the ground keeps to the times that count. The point of an overlap is in both. */
    public class GroundModelQueryTest
    {
        private static const KINDS:Array = ["rough", "steps", "hills"];

        private var _random:SeededRandom = new SeededRandom(2139);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _wrong:Complaints = new Complaints();
        private var _query:GroundModelQuery = new GroundModelQuery();
        private var _out:ContactPoint = new ContactPoint();

        // The ground, and a structure that overlaps it.
        private var _terrain:Terrain;
        private var _structure:BoundingStructure;
        private var _placement:Placement = new Placement();
        private var _maxDistance:Number = 0;

        // Until shortly before the touch there is none; until shortly after it, and from shortly before it on, there is the same.
        [Test]
        public function aSweepKeepsToTheTimesThatCount():void
        {
            var met:int = 0;
            for (var i:int = 0; met < Effort.choose(200, 4000, 60); i++)
            {
                makeOverlap(i);
                var down:RelativeMotion = new RelativeMotion();
                down.endAfter(_random.between(-1, 1) * _maxDistance, _random.between(-1, 1) * _maxDistance, -10 * _maxDistance);
                setQuery();
                if (_query.overlapsAt(down, 0))
                {
                    continue;
                }
                _query.findImpact(down, _out);
                var time:Number = down.time;
                if (!(time > 0.02 && time < 0.98))
                {
                    continue;
                }
                met++;
                down.latest = time - 0.01;
                _query.findImpact(down, _out);
                _wrong.addIf(down.time != RelativeMotion.NEVER, "a touch after the latest time", i + ": " + down.time);
                down.latest = time + 0.01;
                _query.findImpact(down, _out);
                _wrong.addIf(!(Math.abs(down.time - time) < 1e-9), "until a latest time", i + ": " + down.time + " instead of " + time);
                down.earliest = time - 0.01;
                _query.findImpact(down, _out);
                _wrong.addIf(!(Math.abs(down.time - time) < 1e-9), "from an earliest time on", i + ": " + down.time + " instead of " + time);
            }
            _wrong.assertNone();
        }

        [Test]
        public function thePointOfAnOverlapIsInBoth():void
        {
            var points:ClosestPoints = new ClosestPoints();
            var onSurface:int = 0;
            for (var i:int = 0; i < Effort.choose(400, 8000, 100); i++)
            {
                makeOverlap(i);
                setQuery();
                _query.findClosest(true, points);
                var slack:Number = 1e-9 * (_maxDistance + Math.abs(_placement.z));
                var height:Number = heightAround(points.a.x, points.a.y, slack);
                var placed:BoundingStructure = _structure.place(_placement);
                placed.widen(slack);
                onSurface += height - points.a.z < slack ? 1 : 0;
                _wrong.addIf(points.distance != 0 || points.a.z != points.b.z, "distance", i + ": " + points.distance);
                _wrong.addIf(!(points.a.z <= height + slack), "above the ground", i + ", " + _structure + ": " + points.a.z + " above " + height);
                _wrong.addIf(!placed.contains(points.a), "outside", i + ", " + _structure);
            }
            _wrong.assertNone();
            assertTrue(onSurface > 0);
        }

        // The greatest height of the ground near a place: there, because it may be on a ridge, and around it, because it may be the side of a column
        // or the ground's border.
        private function heightAround(x:Number, y:Number, slack:Number):Number
        {
            var greatest:Number = -Infinity;
            for each (var away:Array in [[0, 0], [-1, -1], [1, -1], [-1, 1], [1, 1]])
            {
                var height:Number = _terrain.heightAt(x + away[0] * slack, y + away[1] * slack);
                greatest = height > greatest ? height : greatest;
            }
            return greatest;
        }

        private function makeOverlap(i:int):void
        {
            do
            {
                _terrain = RandomGround.make(KINDS[i % KINDS.length], _random);
                _maxDistance = _terrain.cellWidth * _random.logBetween(0.3, 2);
                _structure = _structures.ofKind(i % 4, _maxDistance, 0);
                _placement.x = _terrain.x + _random.between(0.2, 0.8) * _terrain.columns * _terrain.cellWidth;
                _placement.y = _terrain.y + _random.between(0.2, 0.8) * _terrain.rows * _terrain.cellWidth;
                _placement.z = _terrain.heightAt(_placement.x, _placement.y) + _random.between(-1.5, 0.5) * _maxDistance;
                setQuery();
            }
            while (!_query.overlapsAt(RelativeMotion.NONE, 0));
        }

        private function setQuery():void
        {
            _query.setTo(_terrain.grid, null, _structure, _placement, 1, false);
        }
    }
}
