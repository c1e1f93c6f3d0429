package starlogo.intersection
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Hull;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;

    /** Hulls that are as thin as rounding leaves flat models. */
    public class ThinHullsTest
    {
        private var _motion:RelativeMotion = new RelativeMotion();

        // Three corners of the plate are on one line up to single precision, and one of the mover is near that line.
        [Test]
        public function aPlateIsMet():void
        {
            var plate:Hull = new Hull(new <Number>[1, -1.0000007829691098, 0, 0.5, 0, -5e-7, 1, 0.5, 5e-7]);
            var mover:Hull = new Hull(new <Number>[-0.24999936296053743, 0, -1.715768165886402e-7, 0.9999996975788031, -0.250000287481308,
                        -5.227958071045578e-7, 4.1818805411458015e-7, -0.49999919568140994, 0, -1, 0.25, -0.5, 6.190270208753645e-7, 0, 0,
                        0.24999990028200345, -0.25, -0.49999918368785407]);
            mover.translate(new Vector3D(0.4744550487492234, 0, -1.0464873407501727));
            _motion.x = 0.1;
            _motion.z = 2.0464873407501727;
            for (var i:int = 0; i < 200; i++)
            {
                StructurePairs.findTimeOfImpact(mover, plate, _motion);
                assertTrue(i + ": " + _motion.time, _motion.time > 0.4 && _motion.time < 0.6);
                mover.translate(new Vector3D(1e-4, 0, 0));
            }
        }

        // Beside a plate: a motion away from it or along it does not meet it.
        [Test]
        public function aPlateIsPassed():void
        {
            var plate:Hull = new Hull(new <Number>[1000, -1000, 5, 999, -1001, 4.999999999931322, 1000.25, -999.75, 4.9999999999999964, 1000.00000000039,
                        -999.75, 5.0000000000000036, 1000.25, -1000.5, 4.999999999680604]);
            var mover:Hull = new Hull(new <Number>[1000.25, -999.6257941001095, 4.999999999004904, 999.5, -1000, 4.1632788251154125, 1000.5, -999.5,
                        4.999999999717632, 999.5, -1000.5, 4.5, 1000.25, -1000, 4.9999999991418695, 999.5, -1000, 4.5, 1000, -999.9999999992004, 4]);
            for each (var z:Number in [0, -1e-9, -1])
            {
                _motion.x = z == 0 ? 1 : 0;
                _motion.z = z;
                StructurePairs.findTimeOfImpact(mover, plate, _motion);
                assertEquals(z + "", RelativeMotion.NEVER, _motion.time);
            }
            for each (z in [1.5, 0.1, 1e-3])
            {
                _motion.x = 0;
                _motion.z = z;
                StructurePairs.findTimeOfImpact(mover, plate, _motion);
                assertTrue(z + ": " + _motion.time, _motion.time * z > 7e-10 && _motion.time * z < 9e-10);
            }
        }

        // The gap is a little longer than that of a touch, and hidden by rounding along each axis. The mover slides along the plate, which it does not touch.
        [Test]
        public function aPlateIsPassedAtAGapAsShortAsRounding():void
        {
            var mover:Hull = new Hull(new <Number>[0, -0.5, -8.6e-14, 2, 0.5, -8.8e-14, 0, 0.5, -8.8e-14, 2, 0, -8.4e-14]);
            var plate:Hull = new Hull(new <Number>[1, 1, 0, -0.25, 0.5, 4e-15, -0.5, -0.25, -1e-15, 0.5, 0, -2e-15, 0.5, 1, 0]);
            _motion.x = 1;
            _motion.z = 1e-14;
            StructurePairs.findTimeOfImpact(mover, plate, _motion);
            assertEquals(RelativeMotion.NEVER, _motion.time);
        }

        // The middle of a border sticks out by as little as rounding. The edges on its two sides are nearly in line, but not in a flat side.
        [Test]
        public function theBorderOfAPlateIsAsNearAsItIs():void
        {
            for each (var thickness:Number in [0, 6e-9, 1e-7, 1e-5, 1e-3])
            {
                var plate:Hull = new Hull(new <Number>[-1, 0, 0, 1, 0, 0, 0, 1e-7, 0, -0.3, -1, 0, 1.2, -0.4, thickness]);
                var cube:Hull = new Hull(new <Number>[0, 0, -0.5, 0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0, 1, -0.5, 0, 0, 0.5, 0.5, 0.5, 0.5, -0.5, 0.5, 0.5,
                            0, 1, 0.5]);
                cube.translate(new Vector3D(0.2, -0.01, 0.1));
                var contact:ContactPoint = new ContactPoint();
                StructurePairs.findContact(cube, plate, RelativeMotion.NONE, contact);
                assertTrue(thickness + ": " + contact.depth, Math.abs(contact.depth - 0.01) < 1e-6);
                assertTrue(thickness + ": " + contact.normalY, contact.normalY > 1 - 1e-6);
            }
        }

        // In each pair a point of the one is over an edge of the other, but the closest points are elsewhere. The distances are those of exact arithmetic.
        [Test]
        public function distancesAreThoseOfExactArithmetic():void
        {
            assertDistance(0, new <Number>[999.5000000000058, -1000.3499999999959, -0.2500000000306791, -0.4999999999317879, 0.34999999999593, -0.24999999993124855,
                        0.49999999999420197, -0.15000000000407, 5.679123837865063e-12, 0.49999999999420197, 0.59999999999593, 0.2500000000056791,
                        -0.500000000050477, -0.6499999999838337, -0.24999999999432088, -5.7980287238024175e-12, -0.15000000000407, 0.24999999991421137],
                    new <Number>[1000.1000000000023, -999.9500000000079, -1.1215611277148127e-11, -0.10000000000229647, -0.04999999999211013,
                        4.0988570693880315e-11, -0.09999999999035936, 0.19999999999504325, -2.981122205033899e-11, -0.10000000000229647,
                        -0.30000000007146355, 1.1215611277148127e-11, 0.8999999999977035, -0.29999999993935944, -7.595497769303621e-11,
                        -0.6000000000022965, 0.45000000000788987, 5.3562017772346734e-11]);
            assertDistance(6.671878503049269e-10, new <Number>[1000.107142860338, -1000.4285714270898, -0.17857143053703425, 0.1428571495334836, -0.07142857291023574, 0.17857142803703424,
                        0.142857139670582, -0.5714285652697981, 0.1785714346050103, -1.1071428551703093, -0.5714285729102357, -0.32142857149189347,
                        0.3928571458412762, -0.07142857291023574, 0.17857142986984645, -0.3571428560849199, 0.17857142708976426, -0.07142857709406619,
                        0.8928571396620555, 0.9285714298208632, -0.07142857196296576],
                    new <Number>[999.7000000011789, -1000.3999999984197, -6.759260045364499e-10, 0.049999998821135705, -0.10000000158026978,
                        6.759260045364499e-10, -0.6999999933968866, -0.10000000158026978, 7.266324028372764e-9, -0.7000000030661795, 0.3999999984197302,
                        -9.294102041982114e-9, 0.7999999988211357, -0.10000000158026978, 6.759260045364499e-10]);
        }

        private static function assertDistance(expected:Number, a:Vector.<Number>, b:Vector.<Number>):void
        {
            var kernel:ConvexKernel = new ConvexKernel();
            var closest:ClosestPoints = new ClosestPoints();
            kernel.findClosest(shapeOf(a), shapeOf(b), closest);
            assertTrue(closest.distance + "", Math.abs(closest.distance - expected) < 1e-15);
            assertEquals(expected == 0, kernel.areTouching(shapeOf(a), shapeOf(b)));
        }

        // The hull of points, which are relative to the first three numbers, in their order.
        private static function shapeOf(numbers:Vector.<Number>):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            shape.setHull(new Vector3D(numbers[0], numbers[1], numbers[2]), numbers.slice(3), new Vector.<int>(), new Vector.<int>());
            return shape;
        }
    }
}
