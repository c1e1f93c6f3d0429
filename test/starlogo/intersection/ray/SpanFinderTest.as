package starlogo.intersection.ray
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import support.Effort;
    import support.RayReference;
    import support.Structures;
    import support.assertThrows;

    /** Rays against spheres, capsules, boxes and hulls. */
    public class SpanFinderTest
    {
        private static const CONVEX:ConvexSpanFinder = new ConvexSpanFinder();
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX, BoundingStructure.HULL];

        [Test]
        public function meetsWhatGoingAlongTheRayMeets():void
        {
            var random:SeededRandom = new SeededRandom(2201);
            var structures:RandomStructures = new RandomStructures(random);
            for each (var kind:int in KINDS)
            {
                var counts:Array = [0, 0, 0];
                for (var i:int = 0; i < Effort.choose(1500, 60000); i++)
                {
                    var structure:BoundingStructure = structures.ofKind(kind, random.logBetween(0.1, 3), 2);
                    if (i % 7 == 0)
                    {
                        flatten(structure, random);
                    }
                    var origin:Vector3D = structures.position(4);
                    var direction:Vector3D = towards(structure, origin, random, structures);
                    var ray:Ray = rayOf(origin, direction);
                    var expected:Number = RayReference.firstTouch(structure, origin, direction, 50, 1e-13);
                    var entry:RayCrossing = new RayCrossing();
                    var isMet:Boolean = enters(ray, structure, entry);
                    if (isNaN(expected))
                    {
                        counts[2]++;
                        continue;
                    }
                    var message:String = structure + ", " + Structures.numbersOf(structure) + ", from " + origin + " along " + direction;
                    assertEquals(message, expected < Infinity, isMet);
                    counts[isMet ? 1 : 0]++;
                    if (isMet)
                    {
                        assertTrue(message + ": " + expected + ", not " + entry.distance, Math.abs(expected - entry.distance) < 1e-7);
                        assertNormal(message, entry, structure, origin, direction);
                    }
                }
                assertTrue("kind " + kind + ", not met, met, not clear: " + counts, counts[0] > 100 && counts[1] > 300 && counts[2] < 0.05 * i);
            }
        }

        [Test]
        public function alongAxesAndFacesBordersCount():void
        {
            var box:Box = new Box(new Vector3D(1, 2, 3), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 0.5, 0);
            assertEquals("in its plane", 4, distanceTo(box, new Vector3D(-4, 2, 3), new Vector3D(2, 0, 0)));
            assertEquals("along an edge", 4, distanceTo(box, new Vector3D(-4, 2.5, 3), new Vector3D(1, 0, 0)));
            assertEquals("beside it", Infinity, distanceTo(box, new Vector3D(-4, 2.5 + 1e-12, 3), new Vector3D(1, 0, 0)));
            assertEquals("across it", 7, distanceTo(box, new Vector3D(1.5, 1.5, 10), new Vector3D(0, 0, -1)));
            assertEquals("away", Infinity, distanceTo(box, new Vector3D(1.5, 1.5, 10), new Vector3D(0, 0, 1)));
            assertEquals("from a corner", 0, distanceTo(box, new Vector3D(2, 2.5, 3), new Vector3D(1, 1, 1)));
            var sphere:Sphere = new Sphere(new Vector3D(0, 0, 5), 2);
            assertTrue(Math.abs(distanceTo(sphere, new Vector3D(2, 0, 0), new Vector3D(0, 0, 3)) - 5) < 1e-5);
            assertTrue(Math.abs(distanceTo(sphere, new Vector3D(0, 0, 0), new Vector3D(0, 0, 1e-200)) - 3) < 1e-12);
            var capsule:Capsule = new Capsule(new Vector3D(0, 0, 1), new Vector3D(0, 0, 4), 1);
            assertTrue("along it", Math.abs(distanceTo(capsule, new Vector3D(0.6, 0, -2), new Vector3D(0, 0, 1e200)) - 2.2) < 1e-12);
            assertTrue("across it", Math.abs(distanceTo(capsule, new Vector3D(3, 0.6, 2), new Vector3D(-1, 0, 0)) - 2.2) < 1e-12);
            assertEquals("beside it", Infinity, distanceTo(capsule, new Vector3D(3, 0, 5.5), new Vector3D(-1, 0, 0)));
        }

        [Test]
        public function raysThatTouchCount():void
        {
            var random:SeededRandom = new SeededRandom(2207);
            var structures:RandomStructures = new RandomStructures(random);
            var kinds:Array = ["sphere", "capsule", "capsule without length", "box", "hull"];
            var missed:Array = [0, 0, 0, 0, 0];
            var met:Array = [0, 0, 0, 0, 0];
            for (var i:int = 0; i < 1000; i++)
            {
                // the ray touches the edge along z, or the surface there, in the plane across the outward vector
                var axes:Vector.<Vector3D> = structures.frame();
                var at:Vector3D = structures.position(1);
                var halves:Vector3D = new Vector3D(random.between(0.3, 1), random.between(0.3, 1), random.between(0.3, 1));
                var box:Box = new Box(at, axes[0], axes[1], axes[2], halves.x, halves.y, halves.z);
                var corners:Vector.<Number> = new Vector.<Number>();
                for (var k:int = 0; k < 8; k++)
                {
                    var corner:Vector3D = along(at, axes, k & 1 ? halves.x : -halves.x, k & 2 ? halves.y : -halves.y, k & 4 ? halves.z : -halves.z);
                    corners.push(corner.x, corner.y, corner.z);
                }
                var end:Vector3D = along(at, axes, 0, 0, halves.z);
                var round:Array = [new Sphere(at, halves.x), new Capsule(at, end, halves.x), new Capsule(at, at, halves.x), box, new Hull(corners)];
                var turn:Number = random.between(0, 7);
                for (var kind:int = 0; kind < kinds.length; kind++)
                {
                    var isRound:Boolean = kind < 3;
                    var outX:Number = isRound ? Math.cos(turn) : Math.SQRT1_2;
                    var outY:Number = isRound ? Math.sin(turn) : Math.SQRT1_2;
                    var aslant:Number = random.between(-0.5, 0.5);
                    var direction:Vector3D = along(new Vector3D(), axes, -outY, outX, aslant);
                    for each (var gap:Number in [0, 1e-12])
                    {
                        var x:Number = (isRound ? halves.x * outX : halves.x) + gap * outX;
                        var y:Number = (isRound ? halves.x * outY : halves.y) + gap * outY;
                        var origin:Vector3D = along(at, axes, x + 3 * outY, y - 3 * outX, -3 * aslant);
                        var isMet:Boolean = distanceTo(round[kind], origin, direction) < Infinity;
                        missed[kind] += !isMet && gap == 0 ? 1 : 0;
                        met[kind] += isMet && gap > 0 ? 1 : 0;
                    }
                }
            }
            assertEquals("missed: " + kinds, "0,0,0,0,0", missed.join());
            assertEquals("met beside them: " + kinds, "0,0,0,0,0", met.join());
        }

        [Test]
        public function degenerateStructuresArePointsAndSegments():void
        {
            assertEquals("a point", 5, distanceTo(new Sphere(new Vector3D(1, 2, 5), 0), new Vector3D(1, 2, 0), new Vector3D(0, 0, 1)));
            assertEquals("past it", Infinity, distanceTo(new Sphere(new Vector3D(1, 2.001, 5), 0), new Vector3D(1, 2, 0), new Vector3D(0, 0, 1)));
            var ball:Capsule = new Capsule(new Vector3D(0, 0, 5), new Vector3D(0, 0, 5), 1);
            assertTrue("a ball", Math.abs(distanceTo(ball, new Vector3D(0, 0, 0), new Vector3D(0, 0, 1)) - 4) < 1e-12);
            var segment:Capsule = new Capsule(new Vector3D(-1, 0, 5), new Vector3D(1, 0, 5), 0);
            assertEquals("a segment", 5, distanceTo(segment, new Vector3D(0.5, 0, 0), new Vector3D(0, 0, 1)));
            assertEquals("along a segment", 3, distanceTo(segment, new Vector3D(-4, 0, 5), new Vector3D(1, 0, 0)));
            var flat:Hull = new Hull(new <Number>[0, 0, 5, 2, 0, 5, 2, 2, 5, 0, 2, 5]);
            assertEquals("a flat hull", 5, distanceTo(flat, new Vector3D(0.5, 1, 0), new Vector3D(0, 0, 1)));
            assertEquals("past it", Infinity, distanceTo(flat, new Vector3D(2.001, 1, 0), new Vector3D(0, 0, 1)));
            assertEquals("in its plane", 3, distanceTo(flat, new Vector3D(-3, 1, 5), new Vector3D(1, 0, 0)));
            assertEquals("along its edge", 3, distanceTo(flat, new Vector3D(-3, 2, 5), new Vector3D(1, 0, 0)));
            var stick:Hull = new Hull(new <Number>[-1, 0, 5, 1, 0, 5]);
            assertEquals("a hull that is a segment", 5, distanceTo(stick, new Vector3D(0.5, 0, 0), new Vector3D(0, 0, 1)));
            assertEquals("along it", 3, distanceTo(stick, new Vector3D(-4, 0, 5), new Vector3D(1, 0, 0)));
            assertEquals("past it", Infinity, distanceTo(stick, new Vector3D(0.5, 0.001, 0), new Vector3D(0, 0, 1)));
            var spot:Hull = new Hull(new <Number>[1, 2, 5]);
            assertEquals("a hull that is a point", 5, distanceTo(spot, new Vector3D(1, 2, 0), new Vector3D(0, 0, 1)));
            assertEquals("past it", Infinity, distanceTo(spot, new Vector3D(1, 2.001, 0), new Vector3D(0, 0, 1)));
            var point:Box = new Box(new Vector3D(1, 2, 5), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
            assertEquals("a box that is a point", 5, distanceTo(point, new Vector3D(1, 2, 0), new Vector3D(0, 0, 1)));
            assertEquals("past it", Infinity, distanceTo(point, new Vector3D(1, 2.001, 0), new Vector3D(0, 0, 1)));
        }

        [Test]
        public function capsulesNearlyAlongTheRay():void
        {
            var random:SeededRandom = new SeededRandom(2203);
            for (var i:int = 0; i < 2000; i++)
            {
                var tilt:Number = random.logBetween(1e-18, 1e-2);
                var around:Number = random.between(0, 7);
                var capsule:Capsule = new Capsule(new Vector3D(0, 0, 0), new Vector3D(3 * tilt * Math.cos(around), 3 * tilt * Math.sin(around), 3), 0.5);
                var x:Number = random.between(-0.4, 0.4);
                var found:Number = distanceTo(capsule, new Vector3D(x, 0, -5), new Vector3D(0, 0, 1));
                assertTrue("tilt " + tilt + ": " + found, Math.abs(found - (5 - Math.sqrt(0.25 - x * x))) < 1e-9);
                found = distanceTo(capsule, new Vector3D(x, 0, 9), new Vector3D(0, 0, -1));
                assertTrue("tilt " + tilt + ", from above: " + found, Math.abs(found - (6 - Math.sqrt(0.25 - x * x))) < 0.2);
            }
        }

        [Test]
        public function whatPassesTheSideAndTheRimOfALongCapsuleMeetsIt():void
        {
            var random:SeededRandom = new SeededRandom(2207);
            var structures:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 4000; i++)
            {
                var length:Number = random.logBetween(1, 1e6);
                var axis:Vector3D = structures.direction();
                var across:Vector3D = axis.crossProduct(structures.direction());
                across.normalize();
                var other:Vector3D = axis.crossProduct(across);
                var end:Vector3D = axis.clone();
                end.scaleBy(length);
                var rim:Vector3D = end.add(across);
                var angle:Number = random.between(0.01, 0.2);
                var side:Vector3D = new Vector3D();
                for each (var part:Array in [[axis, 0.3 * length], [across, Math.cos(angle)], [other, Math.sin(angle)]])
                {
                    side.x += part[1] * part[0].x;
                    side.y += part[1] * part[0].y;
                    side.z += part[1] * part[0].z;
                }
                var way:Vector3D = rim.subtract(side);
                way.scaleBy(1.1);
                var capsule:Capsule = new Capsule(new Vector3D(), end, 1);
                var message:String = "of length " + length + " at an angle of " + angle;
                assertTrue("in at the side, " + message, enters(rayOf(rim.subtract(way), way), capsule, new RayCrossing()));
                way.negate();
                assertTrue("in at the rim, " + message, enters(rayOf(side.subtract(way), way), capsule, new RayCrossing()));
            }
        }

        [Test]
        public function refusesCylindersAndDirectionsThatAreNone():void
        {
            assertThrows(ArgumentError, /no test of rays/, SpanFinder.find, new Ray(), new Cylinder(new Vector3D(), new Vector3D(1, 0, 0), 1), null, new RaySpan());
            var ray:Ray = rayOf(new Vector3D(), new Vector3D(0, 3, 0));
            for each (var direction:Vector3D in [new Vector3D(), new Vector3D(NaN, 0, 1), new Vector3D(0, Infinity, 1), new Vector3D(1, 0, NaN)])
            {
                assertThrows(ArgumentError, /needs a direction/, ray.aim, new Vector3D(), direction);
            }
            assertEquals("as it was", 1, ray.direction.y);
            for each (var length:Number in [5e-324, 1e-310, 1e-160, 1, 1e160, 1.7e308])
            {
                ray.aim(new Vector3D(), new Vector3D(length, -length, 0));
                assertTrue("length " + length, Math.abs(ray.direction.x - Math.SQRT1_2) < 1e-15 && Math.abs(ray.direction.y + Math.SQRT1_2) < 1e-15);
                assertEquals(0, ray.direction.z);
            }
        }

        private static function along(at:Vector3D, axes:Vector.<Vector3D>, x:Number, y:Number, z:Number):Vector3D
        {
            return new Vector3D(at.x + x * axes[0].x + y * axes[1].x + z * axes[2].x, at.y + x * axes[0].y + y * axes[1].y + z * axes[2].y,
                    at.z + x * axes[0].z + y * axes[1].z + z * axes[2].z);
        }

        // Flat, or thin, or one point.
        private static function flatten(structure:BoundingStructure, random:SeededRandom):void
        {
            if (structure is Box)
            {
                Box(structure).halfY = random.pick([0, 1e-6]);
            }
            else if (structure is Capsule)
            {
                Capsule(structure).end = Capsule(structure).start.clone();
            }
        }

        // To a point of it, or past it.
        private static function towards(structure:BoundingStructure, origin:Vector3D, random:SeededRandom, structures:RandomStructures):Vector3D
        {
            if (random.chance(0.2))
            {
                return structures.direction();
            }
            var direction:Vector3D = Structures.pointOf(structure, random, random.between(0, 1.6)).subtract(origin);
            direction.normalize();
            return direction;
        }

        private static function assertNormal(message:String, entry:RayCrossing, structure:BoundingStructure, origin:Vector3D, direction:Vector3D):void
        {
            var normal:Vector3D = entry.normal.clone();
            assertTrue(message + ": length of " + normal, Math.abs(normal.length - 1) < 1e-9);
            assertTrue(message + ": against the ray", normal.dotProduct(direction) < 1e-6);
            if (entry.distance > 0)
            {
                // a step out along it leads as far away
                normal.scaleBy(1e-3);
                var at:Vector3D = direction.clone();
                at.scaleBy(entry.distance);
                var gap:Number = RayReference.distance(structure, origin.add(at).add(normal));
                assertTrue(message + ": out of it, " + gap, Math.abs(gap - 1e-3) < 1e-6);
            }
        }

        private static function distanceTo(structure:BoundingStructure, origin:Vector3D, direction:Vector3D):Number
        {
            var entry:RayCrossing = new RayCrossing();
            return enters(rayOf(origin, direction), structure, entry) ? entry.distance : Infinity;
        }

        private static function enters(ray:Ray, structure:BoundingStructure, out:RayCrossing):Boolean
        {
            var span:RaySpan = new RaySpan();
            return SpanFinder.find(ray, structure, CONVEX, span) && out.setToEntry(ray, span);
        }

        private static function rayOf(origin:Vector3D, direction:Vector3D):Ray
        {
            var ray:Ray = new Ray();
            ray.aim(origin, direction);
            return ray;
        }
    }
}
