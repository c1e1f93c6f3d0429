package starlogo.convex
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import support.Complaints;
    import support.ConvexVectors;
    import support.Effort;
    import support.RandomConvex;

    use namespace engine;

    /**
     * Convex shapes of all kinds and ten families against exact arithmetic, in either order. test/oracle/convex makes the pairs, and tries any number of
     * others in Node. Printed: the largest errors.
     */
    public class ConvexTruthTest
    {
        public static const FIXTURES:Array = ConvexVectors.FIXTURES;

        // of the sizes
        private static const DISTANCE:Number = 1e-12;

        // of the coordinates
        private static const PLACES:Number = 1e-15;

        // the gap across which shapes touch: of the sizes, and of the coordinates
        private static const TOUCHING:Number = 5e-14;
        private static const TOUCHING_PLACES:Number = 1.2e-15;

        // of the larger extent
        private static const CONTACT:Number = 1e-9;
        private static const CONTACT_POINT:Number = 1e-8;

        private var _pair:ConvexKernel = new ConvexKernel();
        private var _draw:RandomConvex = new RandomConvex(new SeededRandom(7102));
        private var _wrong:Complaints = new Complaints();

        // of the pair at hand
        private var _size:Number;
        private var _extent:Number;
        private var _places:Number;
        private var _offset:Vector3D;

        [Test]
        public function answersAreThoseOfExactArithmetic():void
        {
            var pairs:ConvexVectors = new ConvexVectors();
            var touching:int = 0;
            var hits:int = 0;
            var count:int = 0;
            var worst:Object = {distance: 0, contact: 0};
            var every:int = Effort.choose(1, 1, 10);
            while (pairs.next())
            {
                if (pairs.index % every != 0)
                {
                    continue;
                }
                measure(pairs);
                checkVerdict(pairs);
                worst.distance = Math.max(worst.distance, checkDistance(pairs));
                if (pairs.distance <= 0)
                {
                    worst.contact = Math.max(worst.contact, checkContact(pairs));
                    touching++;
                }
                checkTime(pairs);
                hits += pairs.earliest <= 1 ? 1 : 0;
                count++;
            }
            trace("  " + count + " pairs, " + touching + " touch, " + hits + " on a way; largest errors, as a part of what is allowed: distance "
                    + worst.distance + ", contact " + worst.contact);
            _wrong.assertNone();
            assertEquals("families", 10, pairs.families.length);
            for each (var family:Object in pairs.families)
            {
                assertTrue(family.name, family.touching > 0.2 * family.pairs && family.motionsThatTouch > 0.2 * family.pairs && family.motionsThatTouch < 0.9 * family.pairs);
            }
            assertTrue(touching + " touch of " + count, touching < 0.8 * count);
        }

        /** A triangle of 1e-6 by 1e-1 crosses the corner of another one, 1e-11 deep. The shares of a tetrahedron's corners are as small as that. */
        [Test]
        public function aSliverThroughACornerIsFound():void
        {
            var triangle:ConvexShape = new ConvexShape();
            triangle.setTriangle(new <Number>[-0.3647521698033146, -1.9543226977463313, 0.16865706655802915, 0.562821130363174, -1.9543226977463313,
                        0.16865706655802915, 0.04187362231233882, -0.01954341464413331, 0.16865706655802915], 0);
            var sliver:ConvexShape = new ConvexShape();
            sliver.setTriangle(new <Number>[0.0418736222934219, -0.01954341464955382, 0.1686570665758107, 0.04187454616595583, -0.019544422597270784,
                        0.16865672039627866, -0.04187397375630608, 0.019543798096618974, -0.16865693488095854], 0);
            var points:ClosestPoints = new ClosestPoints();
            assertTrue(_pair.areTouching(triangle, sliver));
            _pair.findClosest(triangle, sliver, points);
            assertTrue(points.distance <= 1e-15);
        }

        /** Boxes with sides of 1e-5 and of 1e5: several corners are as far along the normal as one, within rounding. */
        [Test]
        public function contactsOfThinBoxesAreOnThem():void
        {
            var thin:ConvexShape = box(-243794.49822304933, -623962.2599381781, -505792.53296245047, -0.6072789193041779, -0.1448510499985012,
                    0.7811725081459802, -0.1335474819608308, 0.9878600295666053, 0.07935762122560652, -0.7831841317536197, -0.056131410983485605,
                    -0.6192510641656837, 7.449646276716685, 0.00011499683362131183, 485611.8264801672);
            var other:ConvexShape = box(0, 0, 0, 0.9281416320788382, 0.2917982233356066, -0.2310993458671268, 0.21197594260122957, -0.9246963708783567,
                    -0.3162322270780079, -0.3059727284585192, 0.24452079368139631, -0.920103402285346, 0.000007769775640176905, 645564.7776618146,
                    1015.4566864851663);
            checkContactPoint(thin, other, 1);
            var needle:ConvexShape = box(28355.344745380266, -32531.242031778675, 71825.59927500102, 0.35919591419254837, -0.9061318444362062,
                    0.22339063482164723, -0.5513912146703119, -0.012930719074066899, 0.8341465847730996, -0.7529581818479547, -0.42279767856844563,
                    -0.5042777998141063, 4.443023827606398, 0.000023186407971213918, 45562.39164223907);
            var capsule:ConvexShape = new ConvexShape();
            new Capsule(new Vector3D(-90107.6704399277, -54208.699588471034, -12601.417580838483),
                    new Vector3D(90107.6704399277, 54208.699588471034, 12601.417580838483), 66635.3380510143).setShape(capsule);
            checkContactPoint(needle, capsule, 1e-3);
            _wrong.assertNone();
        }

        /** The origin is on an edge between two corners, but for 1e-28. Nothing is left of that across the edge. */
        [Test]
        public function pointsOfAGapAsShortAsRoundingAreNumbers():void
        {
            var points:ClosestPoints = new ClosestPoints();
            _pair.findClosest(box(-8, 16, -10, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2.00000000000016, 4.00000000000016, 2.00000000000016),
                    box(0, 8, -2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 6.00000000000032, 4.00000000000032, 6.00000000000032), points);
            assertTrue(points.distance < 1e-27);
            assertTrue(points.a.subtract(new Vector3D(-6, 12, -8)).length < 1e-12);
            assertTrue(points.b.subtract(new Vector3D(-6, 12, -8)).length < 1e-12);
        }

        /** The gap of the cores is 4e-9 of the longer one. The way out is along it, and shorter than all ways across a face or two edges. */

        /** A ball of 1e-11 of a needle's length, at a place within the needle: the way out is across its face, and the ball's middle is the point. */
        [Test]
        public function aTinyBallOnANeedleIsTheContact():void
        {
            var ball:ConvexShape = new ConvexShape();
            new Sphere(new Vector3D(-2324.2954994414868, 7405.301039092563, 4175.392686694984), 1.1249302533384826e-6).setShape(ball);
            var needle:ConvexShape = new ConvexShape();
            var x:Number = -23635.266779967762;
            var y:Number = 75302.93224734013;
            var z:Number = 42458.68022003831;
            needle.setTriangle(new <Number>[x, y, z, x + 27049.11885530567, y - 86179.60545251267, z - 48591.36549429552,
                        x - 3320.473384408615, y + 10579.16483780976, z + 5964.938673090721], 0);
            var contact:ContactPoint = new ContactPoint();
            _pair.findContact(ball, needle, new RelativeMotion(0), contact);
            assertTrue(String(contact.depth), contact.depth < 1e-5);
            var off:Vector3D = new Vector3D(contact.x - ball.origin.x, contact.y - ball.origin.y, contact.z - ball.origin.z);
            assertTrue(String(off), off.length < 1e-4);
        }

        [Test]
        public function theShortestWayOutOfANeedleIsAlongATinyGap():void
        {
            var capsule:ConvexShape = new ConvexShape();
            new Capsule(new Vector3D(0.0000025034947588320478, -0.3430067765085749, -9.470828950530752e-7),
                    new Vector3D(3.377203041665666e-7, -0.34300726683642435, 5.337812969408162e-10), 2.732622363985613e-9).setShape(capsule);
            var needle:ConvexShape = new ConvexShape();
            needle.setTriangle(new <Number>[-3.366928442494316e-7, -0.34300726614292376, 0, 3.366928442494316e-7, -0.34300726614292376, 0,
                        1.4118034968611342e-8, 0.34300726614292376, 0], 0);
            var contact:ContactPoint = new ContactPoint();
            _pair.findContact(capsule, needle, new RelativeMotion(0), contact);
            assertTrue("depth " + contact.depth, Math.abs(contact.depth - 1.382978180131195e-9) < 1e-12);
        }

        private static function box(...numbers):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            var vectors:Array = [];
            for (var i:int = 0; i < 12; i += 3)
            {
                vectors.push(new Vector3D(numbers[i], numbers[i + 1], numbers[i + 2]));
            }
            new Box(vectors[0], vectors[1], vectors[2], vectors[3], numbers[12], numbers[13], numbers[14]).setShape(shape);
            return shape;
        }

        private function checkContactPoint(a:ConvexShape, b:ConvexShape, allowed:Number):void
        {
            var contact:ContactPoint = new ContactPoint();
            _pair.findContact(a, b, new RelativeMotion(0), contact);
            var point:Vector3D = new Vector3D(contact.x, contact.y, contact.z);
            var beside:Number = Math.max(_draw.outside(a, point), _draw.outside(b, point));
            _wrong.addIf(!(beside <= allowed), "contact point", point + ", outside by " + beside);
        }

        private function measure(pairs:ConvexVectors):void
        {
            _size = _extent = _places = 0;
            _offset = middleOf(pairs.a).subtract(middleOf(pairs.b));
        }

        // The middle of a shape. Its size, extent and place are counted.
        private function middleOf(shape:ConvexShape):Vector3D
        {
            var middle:Vector3D = new Vector3D();
            var half:Vector3D = new Vector3D();
            for each (var axis:String in ["x", "y", "z"])
            {
                var forth:Vector3D = new Vector3D();
                forth[axis] = 1;
                var high:Number = RandomConvex.support(shape, forth);
                forth[axis] = -1;
                var low:Number = -RandomConvex.support(shape, forth);
                middle[axis] = (high + low) / 2;
                half[axis] = (high - low) / 2;
                _extent = Math.max(_extent, half[axis]);
                _places += Math.abs(middle[axis]);
            }
            _size += half.length;
            return middle;
        }

        private function checkVerdict(pairs:ConvexVectors):void
        {
            var areTouching:Boolean = _pair.areTouching(pairs.a, pairs.b);
            _wrong.addIf(areTouching != _pair.areTouching(pairs.b, pairs.a), "swapped verdict", pairs.what);
            _wrong.addIf(pairs.distance <= 0 && !areTouching, "missed", pairs.what + ": " + pairs.distance);
            _wrong.addIf(pairs.distance > TOUCHING * _size + TOUCHING_PLACES * _places && areTouching, "false hit", pairs.what + ": " + pairs.distance);
        }

        private function checkDistance(pairs:ConvexVectors):Number
        {
            var points:ClosestPoints = new ClosestPoints();
            var swapped:ClosestPoints = new ClosestPoints();
            _pair.findClosest(pairs.a, pairs.b, points);
            _pair.findClosest(pairs.b, pairs.a, swapped);
            _wrong.addIf(points.distance != swapped.distance || points.a.x != swapped.b.x || points.a.y != swapped.b.y || points.a.z != swapped.b.z
                    || points.b.x != swapped.a.x || points.b.y != swapped.a.y || points.b.z != swapped.a.z, "swapped distance", pairs.what);
            var off:Number = Math.abs(points.distance - Math.max(0, pairs.distance));
            var allowed:Number = DISTANCE * _size + PLACES * _places;
            _wrong.addIf(!(off <= allowed), "distance", pairs.what + ": " + points.distance + ", not " + pairs.distance);
            var beside:Number = Math.max(_draw.outside(pairs.a, points.a), _draw.outside(pairs.b, points.b));
            _wrong.addIf(!(beside <= allowed), "closest points", pairs.what + ": outside by " + beside);
            return off > 0 ? off / allowed : 0;
        }

        // The depth is right, and moving by it along the normal separates the two.
        private function checkContact(pairs:ConvexVectors):Number
        {
            var contact:ContactPoint = new ContactPoint();
            var points:ClosestPoints = new ClosestPoints();
            _pair.findContact(pairs.a, pairs.b, new RelativeMotion(0), contact);
            var swapped:ContactPoint = new ContactPoint();
            _pair.findContact(pairs.b, pairs.a, new RelativeMotion(0), swapped);
            var isSame:Boolean = contact.depth == swapped.depth && contact.normalX == -swapped.normalX && contact.normalY == -swapped.normalY
                && contact.normalZ == -swapped.normalZ;
            // shapes in one place have no side from which they come
            _wrong.addIf(!isSame && _offset.length > CONTACT * _size, "swapped contact", pairs.what + ": " + contact.depth + " and " + swapped.depth);
            var off:Number = Math.abs(contact.depth + pairs.distance);
            var allowed:Number = CONTACT * _extent + PLACES * _places;
            var text:String = pairs.what + ": " + contact.depth + ", not " + -pairs.distance;
            _wrong.addIf(!(off <= allowed), "depth", text);
            var by:Number = contact.depth + 2 * allowed;
            if (allowed > 0)
            {
                _pair.findClosest(RandomConvex.moved(pairs.a, by * contact.normalX, by * contact.normalY, by * contact.normalZ), pairs.b, points);
                _wrong.addIf(!(points.distance > 0), "still touching", text);
            }
            var beside:Number = Math.max(_draw.outside(pairs.a, new Vector3D(contact.x, contact.y, contact.z)), _draw.outside(pairs.b, new Vector3D(contact.x, contact.y, contact.z)));
            _wrong.addIf(!(beside <= contact.depth + CONTACT_POINT * _extent + PLACES * _places), "contact point", pairs.what + ": outside by " + beside);
            return off > 0 ? off / allowed : 0;
        }

        private function checkTime(pairs:ConvexVectors):void
        {
            var motion:RelativeMotion = pairs.motion;
            _pair.findTimeOfImpact(pairs.a, pairs.b, motion);
            var isRight:Boolean = pairs.earliest > 1 ? motion.time == RelativeMotion.NEVER : motion.time >= pairs.earliest && motion.time <= pairs.latest;
            _wrong.addIf(!isRight, "time", pairs.what + ": " + motion.time + ", not between " + pairs.earliest + " and " + pairs.latest);
        }
    }
}
