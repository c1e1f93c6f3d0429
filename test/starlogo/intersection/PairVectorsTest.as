package starlogo.intersection
{
    import evaluation.literal.LiteralTests;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import support.Complaints;
    import support.MotionVectors;
    import support.PairVectors;
    import support.SurfaceDistance;

    /**
     * The kernels against 24,000 pairs of structures, in either order of the arguments. The oracle knows the signed distance of each pair exactly, and of
     * a motion of the first one the time of impact and the normal there, proved in 60 digits. Printed: the share of hits in each family, how often the
     * thesis's own algorithms are wrong, and the largest errors.
     */
    public class PairVectorsTest
    {
        public static const FIXTURES:Array = MotionVectors.fixtures("sphere-sphere", "sphere-capsule", "sphere-box",
                "capsule-capsule", "capsule-box", "box-box");

        // all pairs of these families collide
        private static const ALL_HIT:Array = ["containing", "concentric", "through"];

        // of the size of the larger structure
        private static const DISTANCE:Number = 1e-14;

        // of the coordinates
        private static const ROUNDING:Number = 1e-15;

        // The oracle's times are within 1e-9; more is lost where the structures only graze each other.
        private static const TIME:Number = 1e-8;
        private static const NORMAL:Number = 1e-5;

        private var _pair:ClosestPoints = new ClosestPoints();
        private var _turned:ClosestPoints = new ClosestPoints();
        private var _touch:ContactPoint = new ContactPoint();
        private var _back:ContactPoint = new ContactPoint();
        private var _motionBack:RelativeMotion = new RelativeMotion();
        private var _wrong:Complaints = new Complaints();
        private var _touches:int = 0;
        private var _normals:int = 0;
        private var _worst:Object = {distance: 0, time: 0, depth: 0, normal: 0};

        [Test]
        public function sphereSphere():void
        {
            check("sphere-sphere", null);
        }

        [Test]
        public function sphereCapsule():void
        {
            check("sphere-capsule", null);
        }

        [Test]
        public function sphereBox():void
        {
            check("sphere-box", LiteralTests.sphereBox);
        }

        [Test]
        public function capsuleCapsule():void
        {
            check("capsule-capsule", LiteralTests.capsuleCapsule);
        }

        [Test]
        public function capsuleBox():void
        {
            check("capsule-box", LiteralTests.capsuleBox);
        }

        [Test]
        public function boxBox():void
        {
            check("box-box", LiteralTests.boxBox);
        }

        private function check(name:String, literal:Function):void
        {
            var motions:MotionVectors = new MotionVectors(name);
            var pairs:PairVectors = motions.pairs;
            var tallies:Array = [];
            var tally:FamilyTally = null;
            while (motions.next())
            {
                if (tally == null || tally.name != pairs.family)
                {
                    tally = new FamilyTally(pairs.family);
                    tallies.push(tally);
                }
                tally.add(pairs.isHit, literal == null || literal(pairs.a, pairs.b) == pairs.isHit);
                checkHit(pairs);
                checkDistance(pairs);
                checkMotion(motions);
            }
            trace("  " + name + ": " + pairs.count + " pairs, " + _touches + " touches on the way, " + _normals + " normals; % hits (thesis wrong): "
                    + tallies.join(", "));
            trace("    largest errors: distance " + _worst.distance + " of the size, time " + _worst.time + ", depth " + _worst.depth
                    + " of the size, normal " + _worst.normal);
            _wrong.assertNone();
            for each (tally in tallies)
            {
                var isAllowed:Boolean = ALL_HIT.indexOf(tally.name) >= 0 ? tally.share == 100 : tally.share >= 20 && tally.share <= 80;
                assertTrue("hits of " + tally.name + ": " + tally.share + " %", isAllowed);
            }
            assertTrue("touches: " + _touches, _touches > 0.4 * pairs.count && _touches < 0.8 * pairs.count);
            assertTrue("normals: " + _normals, _normals > 0.5 * _touches);
        }

        private function checkHit(pairs:PairVectors):void
        {
            _wrong.addIf(intersects(pairs.a, pairs.b) != pairs.isHit || intersects(pairs.b, pairs.a) != pairs.isHit,
                    pairs.family + (pairs.isHit ? ": missed" : ": false hit"), pairs.a + " and " + pairs.b);
        }

        // How far they are apart; and the closest points, each on its structure.
        private function checkDistance(pairs:PairVectors):void
        {
            var size:Number = Math.max(halfDiagonal(pairs.a), halfDiagonal(pairs.b));
            var truth:Number = Math.max(0, pairs.distance);
            StructurePairs.findClosest(pairs.a, pairs.b, _pair);
            StructurePairs.findClosest(pairs.b, pairs.a, _turned);
            note(pairs.family, "distance", Math.abs(_pair.distance - truth) / Math.max(size, truth), DISTANCE);
            assertEquals(pairs.family + ": hit", truth == 0, _pair.distance <= DISTANCE * size);
            assertEquals(pairs.family + ", swapped", _pair.distance, _turned.distance);
            var pointA:Vector3D = _pair.a.clone();
            var pointB:Vector3D = _pair.b.clone();
            var slack:Number = 10 * DISTANCE * (size + truth) + ROUNDING * (pointA.length + pointB.length);
            var isOnBoth:Boolean = truth > 0 ? SurfaceDistance.of(pairs.a, pointA) <= slack && SurfaceDistance.of(pairs.b, pointB) <= slack
                : isIn(pairs.a, pointA, slack) && isIn(pairs.b, pointA, slack);
            _wrong.addIf(!isOnBoth || Math.abs(Vector3D.distance(pointA, pointB) - truth) > slack, pairs.family + ": closest points", pointA + " and " + pointB);
        }

        // The first touch on the way, and the contact there.
        private function checkMotion(motions:MotionVectors):void
        {
            var way:RelativeMotion = motions.way;
            _motionBack.setReversed(way);
            StructurePairs.findTimeOfImpact(motions.a, motions.b, way);
            StructurePairs.findTimeOfImpact(motions.b, motions.a, _motionBack);
            var time:Number = way.time;
            var timeBack:Number = _motionBack.time;
            var isTouching:Boolean = !isNaN(motions.time);
            if ((time <= 1) != isTouching || (timeBack <= 1) != isTouching)
            {
                _wrong.add(motions.family + ": time", time + ", " + timeBack + " and not " + motions.time);
                return;
            }
            if (!isTouching)
            {
                return;
            }
            _touches++;
            note(motions.family, "time", Math.max(Math.abs(time - motions.time), Math.abs(timeBack - motions.time)), TIME);
            StructurePairs.findContact(motions.a, motions.b, way, _touch);
            _motionBack.setReversed(way);
            StructurePairs.findContact(motions.b, motions.a, _motionBack, _back);
            var size:Number = halfDiagonal(motions.a) + halfDiagonal(motions.b);
            note(motions.family, "depth", Math.max(Math.abs(_touch.depth - motions.depth), Math.abs(_back.depth - motions.depth)) / size, TIME);
            if (!isNaN(motions.normalX))
            {
                _normals++;
                note(motions.family, "normal", Math.max(offNormal(_touch, motions, 1), offNormal(_back, motions, -1)), NORMAL);
            }
        }

        private function note(family:String, what:String, error:Number, limit:Number):void
        {
            _worst[what] = Math.max(_worst[what], error);
            _wrong.addIf(!(error <= limit), family + ": " + what, "off by " + error);
        }

        private static function offNormal(touch:ContactPoint, motions:MotionVectors, sign:Number):Number
        {
            return new Vector3D(sign * touch.normalX - motions.normalX, sign * touch.normalY - motions.normalY, sign * touch.normalZ - motions.normalZ).length;
        }

        private static function isIn(structure:BoundingStructure, point:Vector3D, slack:Number):Boolean
        {
            return structure.contains(point) || SurfaceDistance.of(structure, point) <= slack;
        }

        // Of the axis-aligned box around a structure.
        private static function halfDiagonal(structure:BoundingStructure):Number
        {
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            structure.extentsInto(extents);
            return new Vector3D(extents[1] - extents[0], extents[3] - extents[2], extents[5] - extents[4]).length / 2;
        }
    }
}

class FamilyTally
{
    public var name:String;
    private var _count:int = 0;
    private var _hits:int = 0;
    private var _literalWrong:int = 0;

    public function FamilyTally(name:String)
    {
        this.name = name;
    }

    public function add(isHit:Boolean, isLiteralRight:Boolean):void
    {
        _count++;
        _hits += isHit ? 1 : 0;
        _literalWrong += isLiteralRight ? 0 : 1;
    }

    public function get share():Number
    {
        return 100 * _hits / _count;
    }

    public function toString():String
    {
        return name + " " + share.toFixed(0) + (_literalWrong > 0 ? " (" + _literalWrong + ")" : "");
    }
}
