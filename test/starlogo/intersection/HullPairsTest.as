package starlogo.intersection
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Hull;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import support.Effort;
    import support.FrameByFrame;
    import support.cornerOf;

    use namespace engine;

    /** A hull of a box's corners against spheres, capsules, boxes and hulls: all answers are those of the box. */
    public class HullPairsTest
    {
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX];
        private static const NEAR:Number = 1e-12;

        private var _random:SeededRandom = new SeededRandom(7121);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _touching:int = 0;
        private var _met:int = 0;
        private var _deep:int = 0;

        [Test(async, timeout="3600000")]
        public function theyTouchWhatTheBoxTouches():void
        {
            var count:int = Effort.choose(3000, 100000);
            FrameByFrame.repeat(this, count, compareTouch, function():void
                {
                    assertTrue(_touching + "", _touching > count / 5 && _touching < 4 * count / 5);
                });
        }

        private function compareTouch(i:int):void
        {
            var box:Box = Box(_structures.ofKind(BoundingStructure.BOX, _random.logBetween(0.2, 2), 1));
            var other:BoundingStructure = _structures.ofKind(_random.pick(KINDS), _random.logBetween(0.2, 2), 1);
            var result:ClosestPoints = new ClosestPoints();
            StructurePairs.findClosest(box, other, result);
            var isTouching:Boolean = intersects(box, other);
            _touching += isTouching ? 1 : 0;
            var hull:Hull = hullOf(box);
            for each (var second:BoundingStructure in other is Box ? [other, hullOf(Box(other))] : [other])
            {
                var name:String = i + ": " + box + ", " + second;
                assertEquals(name, isTouching, intersects(hull, second));
                assertEquals(name, isTouching, intersects(second, hull));
                compareDistance(name, result.distance, hull, second);
                compareDistance(name, result.distance, second, hull);
            }
        }

        private static function compareDistance(name:String, expected:Number, a:BoundingStructure, b:BoundingStructure):void
        {
            var result:ClosestPoints = new ClosestPoints();
            StructurePairs.findClosest(a, b, result);
            assertTrue(name + ": distance " + result.distance + " instead of " + expected, Math.abs(result.distance - expected) < NEAR);
            var between:Number = Vector3D.distance(result.a, result.b);
            assertTrue(name + ": points " + between, Math.abs(between - result.distance) < NEAR);
        }

        [Test(async, timeout="3600000")]
        public function theyMeetWhenTheBoxDoes():void
        {
            var count:int = Effort.choose(3000, 100000);
            FrameByFrame.repeat(this, count, compareTime, function():void
                {
                    assertTrue(_met + "", _met > count / 20);
                });
        }

        private function compareTime(i:int):void
        {
            var box:Box = Box(_structures.ofKind(BoundingStructure.BOX, _random.logBetween(0.2, 2), 2));
            var other:BoundingStructure = _structures.ofKind(_random.pick(KINDS), _random.logBetween(0.2, 2), 1.5);
            var way:Vector3D = _structures.position(6);
            var expected:Number = timeOf(box, other, way);
            _met += expected > 0 && expected <= 1 ? 1 : 0;
            for each (var second:BoundingStructure in other is Box ? [other, hullOf(Box(other))] : [other])
            {
                var found:Number = timeOf(hullOf(box), second, way);
                var back:Number = timeOf(second, hullOf(box), new Vector3D(-way.x, -way.y, -way.z));
                var name:String = i + ": " + box + ", " + second + " along " + way + ", " + expected + ", " + found + ", " + back;
                assertTrue(name, expected == found || Math.abs(expected - found) < 1e-10);
                assertTrue(name, found == back || Math.abs(back - found) < 1e-13);
            }
        }

        private static function timeOf(a:BoundingStructure, b:BoundingStructure, way:Vector3D):Number
        {
            var motion:RelativeMotion = new RelativeMotion();
            motion.x = way.x;
            motion.y = way.y;
            motion.z = way.z;
            StructurePairs.findTimeOfImpact(a, b, motion);
            return motion.time;
        }

        // As deep, and apart after the depth.
        [Test(async, timeout="3600000")]
        public function theirContactsAreAsDeep():void
        {
            var count:int = Effort.choose(3000, 100000);
            FrameByFrame.repeat(this, count, compareContact, function():void
                {
                    assertTrue(_deep + "", _deep > count / 3);
                });
        }

        private function compareContact(i:int):void
        {
            var box:Box = Box(_structures.ofKind(BoundingStructure.BOX, _random.logBetween(0.2, 2), 0.6));
            var other:BoundingStructure = _structures.ofKind(_random.pick(KINDS), _random.logBetween(0.2, 2), 0.6);
            if (!intersects(box, other))
            {
                return;
            }
            _deep++;
            var expected:ContactPoint = new ContactPoint();
            StructurePairs.findContact(box, other, RelativeMotion.NONE, expected);
            for each (var second:BoundingStructure in other is Box ? [other, hullOf(Box(other))] : [other])
            {
                var contact:ContactPoint = new ContactPoint();
                var hull:Hull = hullOf(box);
                StructurePairs.findContact(hull, second, RelativeMotion.NONE, contact);
                var name:String = i + ": " + box + ", " + second + ", depth " + contact.depth + " instead of " + expected.depth;
                assertTrue(name, contact.depth <= expected.depth + 1e-9 && contact.depth >= expected.depth - 1e-9);
                assertTrue(name, touchesAfter(hull, second, contact, contact.depth - 1e-9) && !touchesAfter(hull, second, contact, contact.depth + 1e-9));
            }
        }

        private static function touchesAfter(a:BoundingStructure, b:BoundingStructure, contact:ContactPoint, by:Number):Boolean
        {
            var moved:BoundingStructure = a.clone().translate(new Vector3D(by * contact.normalX, by * contact.normalY, by * contact.normalZ));
            return intersects(moved, b);
        }

        private static function hullOf(box:Box):Hull
        {
            var points:Vector.<Number> = new Vector.<Number>();
            var corner:Vector3D = new Vector3D();
            for (var i:int = 0; i < 8; i++)
            {
                cornerOf(box, i, corner);
                points.push(corner.x, corner.y, corner.z);
            }
            return new Hull(points);
        }
    }
}
