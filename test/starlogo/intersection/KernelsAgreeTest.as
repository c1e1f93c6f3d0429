package starlogo.intersection
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import support.Complaints;

    /** The tests of structures that stand still, which are written out for speed, answer as the kernels of the same pairs do. */
    public class KernelsAgreeTest
    {
        private static const PAIRS:int = 1500;
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX, BoundingStructure.HULL];

        private var _contact:ContactPoint = new ContactPoint();

        [Test]
        public function sphereSphere():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.SPHERE);
        }

        [Test]
        public function sphereCapsule():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
        }

        [Test]
        public function sphereBox():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.BOX);
        }

        [Test]
        public function capsuleCapsule():void
        {
            check(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
        }

        [Test]
        public function capsuleBox():void
        {
            check(BoundingStructure.CAPSULE, BoundingStructure.BOX);
        }

        [Test]
        public function boxBox():void
        {
            check(BoundingStructure.BOX, BoundingStructure.BOX);
        }

        [Test]
        public function theOtherOrderGivesTheSameDistance():void
        {
            var random:SeededRandom = new SeededRandom(577);
            var structures:RandomStructures = new RandomStructures(random);
            var points:ClosestPoints = new ClosestPoints();
            var others:ClosestPoints = new ClosestPoints();
            for (var i:int = 0; i < PAIRS; i++)
            {
                var a:BoundingStructure = structures.ofKind(random.pick(KINDS), 1, 2);
                var b:BoundingStructure = structures.ofKind(random.pick(KINDS), 1, 2);
                StructurePairs.findClosest(a, b, points);
                StructurePairs.findClosest(b, a, others);
                others.swap();
                var isSame:Boolean = points.distance == others.distance && points.a.x == others.a.x && points.a.y == others.a.y && points.a.z == others.a.z
                    && points.b.x == others.b.x && points.b.y == others.b.y && points.b.z == others.b.z;
                assertTrue(i + ": " + a + ", " + b + ": " + points.distance + ", " + others.distance, isSame);
            }
            var small:Sphere = new Sphere(new Vector3D(0, 0, 0), 0.1);
            var large:Sphere = new Sphere(new Vector3D(1, 0, 0), 0.3);
            StructurePairs.findClosest(small, large, points);
            assertEquals(0.6, points.distance);
        }

        [Test]
        public function theOtherOrderGivesTheSameTimeAndContact():void
        {
            var random:SeededRandom = new SeededRandom(578);
            var structures:RandomStructures = new RandomStructures(random);
            var wrong:Complaints = new Complaints();
            var touches:int = 0;
            for (var i:int = 0; i < 4 * PAIRS; i++)
            {
                var a:BoundingStructure = structures.ofKind(random.pick(KINDS), 1, 2);
                var b:BoundingStructure = structures.ofKind(random.pick(KINDS), 1, 2);
                if (random.chance())
                {
                    moveToOnePlace(a, b);
                }
                var way:RelativeMotion = new RelativeMotion();
                way.endAfter(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3));
                touches += compareOrders(a, b, way, wrong) ? 1 : 0;
                touches += compareOrders(a, b, new RelativeMotion(0), wrong) ? 1 : 0;
            }
            wrong.assertNone();
            assertTrue("touches: " + touches, touches > PAIRS);
        }

        // Of two with different numbers in one place, the other numbers decide which comes first.
        private static function moveToOnePlace(a:BoundingStructure, b:BoundingStructure):void
        {
            var places:Vector.<Vector3D> = new <Vector3D>[placeOf(a), placeOf(b)];
            b.translate(places[0].subtract(places[1]));
            placeOf(b).copyFrom(places[0]);
        }

        private static function placeOf(structure:BoundingStructure):Vector3D
        {
            if (structure is Capsule)
            {
                return Capsule(structure).start;
            }
            if (structure is Sphere)
            {
                return Sphere(structure).center;
            }
            return structure is Box ? Box(structure).center : Hull(structure).center;
        }

        private function compareOrders(a:BoundingStructure, b:BoundingStructure, way:RelativeMotion, wrong:Complaints):Boolean
        {
            var back:RelativeMotion = new RelativeMotion();
            var other:ContactPoint = new ContactPoint();
            var what:String = a + ", " + b;
            back.setReversed(way);
            StructurePairs.findTimeOfImpact(a, b, way);
            StructurePairs.findTimeOfImpact(b, a, back);
            wrong.addIf(way.time != back.time, "time", what + ": " + way.time + ", " + back.time);
            if (!(way.time <= 1))
            {
                return false;
            }
            back.setReversed(way);
            StructurePairs.findContact(a, b, way, _contact);
            StructurePairs.findContact(b, a, back, other);
            // where a stands still, instead of b
            var isSamePoint:Boolean = !way.isStill || _contact.x == other.x && _contact.y == other.y && _contact.z == other.z;
            wrong.addIf(_contact.depth != other.depth || _contact.normalX != -other.normalX || _contact.normalY != -other.normalY
                    || _contact.normalZ != -other.normalZ || !isSamePoint, "contact", what + ": " + _contact.depth + ", " + other.depth);
            return true;
        }

        private function check(kindA:int, kindB:int):void
        {
            var random:SeededRandom = new SeededRandom(500 + 10 * kindA + kindB);
            var structures:RandomStructures = new RandomStructures(random);
            var hits:int = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                var size:Number = random.logBetween(1e-4, 1e4);
                var a:BoundingStructure = structures.ofKind(kindA, size, 0.9 * size);
                var b:BoundingStructure = structures.ofKind(kindB, size, 0.9 * size);
                hits += compare(a, b, "pair " + i) ? 1 : 0;
                if (kindA != BoundingStructure.BOX && kindB != kindA)
                {
                    compareNearTouching(a, b, "pair " + i);
                }
            }
            assertTrue("hits: " + hits, hits > 0.25 * PAIRS && hits < 0.85 * PAIRS);
        }

        // With the first as wide as it just touches, and a few bits more and less.
        private function compareNearTouching(a:BoundingStructure, b:BoundingStructure, what:String):void
        {
            StructurePairs.findContact(a, b, RelativeMotion.NONE, _contact);
            var radius:Number = a is Sphere ? Sphere(a).radius : Capsule(a).radius;
            var touching:Number = radius - _contact.depth;
            if (_contact.depth == 0 || !(touching > 0))
            {
                return;
            }
            for (var bits:int = -8; bits <= 8; bits++)
            {
                radius = touching * (1 + bits * 1e-14);
                if (a is Sphere)
                {
                    Sphere(a).radius = radius;
                }
                else
                {
                    Capsule(a).radius = radius;
                }
                compare(a, b, what + ", " + bits);
            }
        }

        private static function compare(a:BoundingStructure, b:BoundingStructure, what:String):Boolean
        {
            var isHit:Boolean = intersects(a, b);
            var still:RelativeMotion = new RelativeMotion();
            StructurePairs.findTimeOfImpact(a, b, still);
            assertEquals(what, still.time == 0, isHit);
            return isHit;
        }
    }
}
