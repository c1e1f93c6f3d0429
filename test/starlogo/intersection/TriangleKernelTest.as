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
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import support.Complaints;
    import support.Effort;
    import support.PlainDistance;
    import support.SurfaceDistance;
    import support.cornerOf;

    use namespace engine;

    /** When structures that move touch a triangle, and how: against their distances at many times. */
    public class TriangleKernelTest
    {
        private static const NEAR:Number = 1e-9;

        // A box's twelve triangles as a strip of corners: each corner and the next two are a triangle. See cornerOf().
        private static const STRIP:Vector.<int> = new <int>[6, 7, 2, 3, 1, 7, 5, 6, 4, 2, 0, 1, 4, 5];

        private var _random:SeededRandom = new SeededRandom(3806);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _plane:TrianglePlane = new TrianglePlane();
        private var _wrong:Complaints = new Complaints();

        [Test]
        public function timesAndContactsAreThoseOfManySteps():void
        {
            var hits:int = 0;
            var misses:int = 0;
            for (var i:int = Effort.choose(3000, 30000); i > 0; i--)
            {
                var structure:BoundingStructure = _structures.ofKind(i % 3, _random.logBetween(0.02, 2), 2);
                var corners:Vector.<Number> = anyTriangle(i % 4);
                var motion:RelativeMotion = new RelativeMotion(0);
                motion.x = _random.between(-4, 4);
                motion.y = _random.between(-4, 4);
                motion.z = _random.chance(0.2) ? 0 : _random.between(-4, 4);
                if (areTouching(structure, corners, 0))
                {
                    continue;
                }
                var sweep:TriangleKernel = new TriangleKernel();
                var end:Number = Math.min(1, timeOf(sweep, structure, corners, motion));
                var message:String = structure + ", triangle " + corners + ", motion " + [motion.x, motion.y, motion.z] + ", time " + motion.time;
                _wrong.addIf(touchesBefore(structure, corners, motion, end * (1 - 1e-7)), "through", message);
                if (motion.time > 1)
                {
                    misses++;
                    continue;
                }
                hits++;
                assertContact(structure, corners, motion, sweep, message);
            }
            _wrong.assertNone();
            assertTrue(hits + " hits, " + misses + " misses", hits > 100 && misses > 100);
        }

        /** Shortly before the touch, rounding hides the direction of the gap. */
        [Test]
        public function whatComesNearAtAFlatAngleIsMet():void
        {
            var hits:int = 0;
            var closest:ClosestPoints = new ClosestPoints();
            for (var i:int = Effort.choose(2000, 30000); i > 0; i--)
            {
                var structure:BoundingStructure = _structures.ofKind(i % 3, _random.logBetween(0.02, 2), 2);
                var corners:Vector.<Number> = anyTriangle(i % 4);
                var sweep:TriangleKernel = new TriangleKernel();
                closest.distance = Infinity;
                sweep.setStructure(structure, new Placement());
                sweep.findCloser(corners, closest);
                if (!(closest.distance > 1e-3) || areTouching(structure, corners, 0))
                {
                    continue;
                }
                var normal:Vector3D = closest.a.subtract(closest.b);
                normal.normalize();
                var gap:Number = _random.logBetween(1e-7, 1e-3);
                structure.translate(new Vector3D((gap - closest.distance) * normal.x, (gap - closest.distance) * normal.y, (gap - closest.distance) * normal.z));
                var way:Vector3D = normal.crossProduct(new Vector3D(_random.normal(), _random.normal(), _random.normal()));
                way.scaleBy(_random.logBetween(0.001, 1));
                way.decrementBy(new Vector3D(2 * gap * normal.x, 2 * gap * normal.y, 2 * gap * normal.z));
                var motion:RelativeMotion = new RelativeMotion(0);
                motion.x = way.x;
                motion.y = way.y;
                motion.z = way.z;
                var end:Number = Math.min(1, timeOf(sweep, structure, corners, motion));
                hits += motion.time <= 1 ? 1 : 0;
                _wrong.addIf(touchesBefore(structure, corners, motion, end * (1 - 1e-3)), "through",
                        structure + ", triangle " + corners + ", motion " + way + ", time " + motion.time);
            }
            _wrong.assertNone();
            assertTrue(hits + " hits", hits > 100);
        }

        private function touchesBefore(structure:BoundingStructure, corners:Vector.<Number>, motion:RelativeMotion, end:Number):Boolean
        {
            for (var k:int = 1; k <= 16; k++)
            {
                if (areTouching(moved(structure, motion, end * k / 16), corners, 0))
                {
                    return true;
                }
            }
            return false;
        }

        [Test]
        public function aTriangleAtTheBorderOfTouchingIsMet():void
        {
            var apart:int = 0;
            for (var i:int = Effort.choose(1000, 30000); i > 0; i--)
            {
                var structure:BoundingStructure = _structures.ofKind(i % 3, _random.logBetween(0.02, 2), 2);
                var corners:Vector.<Number> = anyTriangle(i % 4);
                var motion:RelativeMotion = new RelativeMotion(0);
                motion.x = _random.between(-4, 4);
                motion.y = _random.between(-4, 4);
                motion.z = _random.between(-4, 4);
                var sweep:TriangleKernel = new TriangleKernel();
                var first:Number = timeOf(sweep, structure, corners, motion);
                for (var k:int = -4; k <= 4 && first > 0 && first < 1; k++)
                {
                    var time:Number = timeOf(sweep, moved(structure, motion, first - k * _random.logBetween(1e-16, 1e-12)), corners, motion);
                    apart += sweep.areTouching(corners) ? 0 : 1;
                    _wrong.addIf(!(time < 1e-9), "not met", structure + ", triangle " + corners + ", motion " + [motion.x, motion.y, motion.z]
                            + ", from " + first + ", step " + k + ": " + time);
                }
            }
            _wrong.assertNone();
            assertTrue(apart + " apart", apart > 100);
        }

        [Test]
        public function nothingIsBehindATriangleWithoutArea():void
        {
            var kernel:TriangleKernel = new TriangleKernel();
            var out:ContactPoint = new ContactPoint();
            for (var i:int = 0; i < 300; i++)
            {
                kernel.setStructure(_structures.ofKind(i % 3, _random.logBetween(0.02, 2), 2), new Placement());
                var corners:Vector.<Number> = new Vector.<Number>(9, true);
                var share:Number = i % 5 / 4;
                for (var k:int = 0; k < 3; k++)
                {
                    corners[k] = _random.between(-5, 5);
                    corners[3 + k] = _random.between(-5, 5);
                    corners[6 + k] = corners[k] + share * (corners[3 + k] - corners[k]);
                }
                _plane.setTriangle(corners, 0);
                _plane.findBehind(kernel.shape, new RelativeMotion(0), out);
                _wrong.addIf(out.depth >= 0, "behind", "triangle " + corners);
            }
            _wrong.assertNone();
        }

        /** Only what touches first on its motion may have a normal that points behind the triangle. */
        [Test]
        public function whatIsInTheSolidAtFirstIsLedOutside():void
        {
            var kernel:TriangleKernel = new TriangleKernel();
            var corners:Vector.<Number> = new <Number>[-10, -10, 0, 10, -10, 0, 0, 10, 0];
            kernel.setStructure(new Sphere(new Vector3D(0, 0, -0.5), 1), new Placement());
            _plane.setTriangle(corners, 0);
            for (var up:int = -1; up <= 1; up++)
            {
                var motion:RelativeMotion = new RelativeMotion(0);
                motion.z = up;
                var out:ContactPoint = new ContactPoint();
                kernel.findContact(corners, motion, out);
                assertEquals(-1, out.normalZ);
                _plane.leadOutside(kernel.shape, motion, out);
                assertEquals("moves by " + up, "1,1.5", [out.normalZ, out.depth].join());
            }
        }

        private function timeOf(sweep:TriangleKernel, structure:BoundingStructure, corners:Vector.<Number>, motion:RelativeMotion):Number
        {
            sweep.setStructure(structure, new Placement());
            _plane.setTriangle(corners, 0);
            motion.time = RelativeMotion.NEVER;
            if (!_plane.areApart(sweep.shape, motion))
            {
                sweep.findTimeOfImpact(corners, motion);
            }
            return motion.time;
        }

        private function assertContact(structure:BoundingStructure, corners:Vector.<Number>, motion:RelativeMotion, sweep:TriangleKernel, message:String):void
        {
            var there:BoundingStructure = moved(structure, motion, motion.time);
            _wrong.addIf(!areTouching(there, corners, NEAR), "no touch", message);
            var out:ContactPoint = new ContactPoint();
            sweep.findContact(corners, motion, out);
            var point:Vector3D = new Vector3D(out.x, out.y, out.z);
            var normal:Vector3D = new Vector3D(out.normalX, out.normalY, out.normalZ);
            var onStructure:Number = SurfaceDistance.of(there, point);
            var onTriangle:Number = PlainDistance.between(numbersOf(corners), [point.x, point.y, point.z, point.x, point.y, point.z, point.x, point.y, point.z]);
            _wrong.addIf(!(onStructure < 1e-7) || !(onTriangle < 1e-7) || out.depth > NEAR,
                    "point", onStructure + ", " + onTriangle + ", depth " + out.depth + ", normal " + normal + ": " + message);
            var apart:BoundingStructure = there.clone().translate(new Vector3D(1e-7 * normal.x, 1e-7 * normal.y, 1e-7 * normal.z));
            _wrong.addIf(Math.abs(normal.length - 1) > 1e-12 || areTouching(apart, corners, 0), "normal", normal + ": " + message);
        }

        private function areTouching(structure:BoundingStructure, corners:Vector.<Number>, tolerance:Number):Boolean
        {
            if (structure.kind == BoundingStructure.BOX)
            {
                return fromBox(structure as Box, corners) <= tolerance;
            }
            var capsule:Capsule = structure as Capsule;
            var start:Vector3D = capsule == null ? Sphere(structure).center : capsule.start;
            var end:Vector3D = capsule == null ? start : capsule.end;
            var radius:Number = capsule == null ? Sphere(structure).radius : capsule.radius;
            var core:Array = [start.x, start.y, start.z, end.x, end.y, end.z, end.x, end.y, end.z];
            return PlainDistance.between(numbersOf(corners), core) <= radius + tolerance;
        }

        private static function fromBox(box:Box, corners:Vector.<Number>):Number
        {
            var strip:Vector.<Number> = new Vector.<Number>();
            var corner:Vector3D = new Vector3D();
            for each (var number:int in STRIP)
            {
                cornerOf(box, number, corner);
                strip.push(corner.x, corner.y, corner.z);
            }
            var from:Vector3D = new Vector3D(corners[0], corners[1], corners[2]).subtract(box.center);
            if (Math.abs(from.dotProduct(box.axisX)) <= box.halfX && Math.abs(from.dotProduct(box.axisY)) <= box.halfY && Math.abs(from.dotProduct(box.axisZ)) <= box.halfZ)
            {
                return 0;
            }
            var distance:Number = Infinity;
            for (var i:int = 0; i < strip.length - 6; i += 3)
            {
                distance = Math.min(distance, PlainDistance.ofTriangles(strip, i, corners, 0));
            }
            return distance;
        }

        private static function numbersOf(corners:Vector.<Number>):Array
        {
            var numbers:Array = [];
            for (var i:int = 0; i < 9; i++)
            {
                numbers.push(corners[i]);
            }
            return numbers;
        }

        private static function moved(structure:BoundingStructure, motion:RelativeMotion, time:Number):BoundingStructure
        {
            return structure.clone().translate(new Vector3D(time * motion.x, time * motion.y, time * motion.z));
        }

        // Large and small ones, needles, and those without area.
        private function anyTriangle(kind:int):Vector.<Number>
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            var size:Number = _random.logBetween(0.2, 10);
            for (var i:int = 0; i < 9; i++)
            {
                corners.push(size * _random.between(-1, 1));
            }
            if (kind == 0)
            {
                var share:Number = _random.between(0, 1);
                for (i = 0; i < 3; i++)
                {
                    corners[6 + i] = corners[i] + share * (corners[3 + i] - corners[i]) + _random.pick([0, 1e-9, 1e-4]) * _random.between(-1, 1);
                }
            }
            return corners;
        }
    }
}
