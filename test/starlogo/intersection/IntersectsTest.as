package starlogo.intersection
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import support.assertThrows;

    public class IntersectsTest
    {
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX];

        [Test]
        public function refusesCylinders():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1);
            var sphere:Sphere = new Sphere(new Vector3D(), 1);
            for each (var pair:Array in [[cylinder, sphere], [sphere, cylinder], [cylinder, cylinder]])
            {
                assertThrows(ArgumentError, "Cylinder", intersects, pair[0], pair[1]);
            }
        }

        [Test]
        public function refusesNull():void
        {
            assertThrows(TypeError, /./, intersects, null, new Sphere(new Vector3D(), 1));
            assertThrows(TypeError, /./, intersects, new Sphere(new Vector3D(), 1), null);
        }

        /** The numbers are exact: squared distances of 25 and 4 and squares of the same size. */
        [Test]
        public function spheresThatJustTouchCollide():void
        {
            var a:Sphere = new Sphere(new Vector3D(1, 2, 3), 2);
            assertTrue("along an axis", intersects(a, new Sphere(new Vector3D(6, 2, 3), 3)));
            assertTrue("across two axes", intersects(a, new Sphere(new Vector3D(1, 5, 7), 3)));
            assertTrue("a point", intersects(a, new Sphere(new Vector3D(1, 2, 1), 0)));
            assertFalse("just apart", intersects(a, new Sphere(new Vector3D(1, 5, 7), 3 - 1e-12)));
        }

        /** Where rounding decides, it decides alike for (a, b) and (b, a), and the extents never contradict a hit. */
        [Test]
        public function givesTheSameAnswerForBothOrdersAtContact():void
        {
            var random:SeededRandom = new SeededRandom(17);
            var structures:RandomStructures = new RandomStructures(random);
            var hits:int = 0;
            var count:int = 0;
            for each (var kind:int in KINDS)
            {
                for (var i:int = 0; i < 60; i++)
                {
                    var a:BoundingStructure = structures.ofKind(kind, 1, 0);
                    var b:BoundingStructure = structures.ofKind(kind, 1, 0);
                    var inside:Number = 0;
                    var outside:Number = 5;
                    var direction:Vector3D = i % 2 == 0 ? structures.direction() : Vector3D.X_AXIS;
                    for (var step:int = 0; step < 60; step++)
                    {
                        var distance:Number = (inside + outside) / 2;
                        var moved:BoundingStructure = b.clone();
                        moved.translate(new Vector3D(direction.x * distance, direction.y * distance, direction.z * distance));
                        var isHit:Boolean = intersects(a, moved);
                        assertEquals("kind " + kind + ", pair " + i + ", step " + step, isHit, intersects(moved, a));
                        assertTrue("extents of kind " + kind + ", pair " + i, !isHit || doExtentsMeet(a, moved));
                        inside = isHit ? distance : inside;
                        outside = isHit ? outside : distance;
                        hits += isHit ? 1 : 0;
                        count++;
                    }
                }
            }
            assertTrue("hits: " + hits + " of " + count, hits > 0.2 * count && hits < 0.8 * count);
        }

        /** Hair-thin capsules that cross at a tiny angle: a hit and a miss are as far apart as rounding lets them. */
        [Test]
        public function findsWhereNearlyParallelCapsulesCross():void
        {
            var random:SeededRandom = new SeededRandom(23);
            for (var i:int = 0; i < 200; i++)
            {
                var angle:Number = random.logBetween(1e-7, 1e-3);
                var crossing:Number = random.between(-0.9, 0.9);
                var radius:Number = 1e-12;
                var a:Capsule = new Capsule(new Vector3D(-1, 0, 0), new Vector3D(1, 0, 0), radius);
                for each (var gap:Number in [1e-12, 3e-12])
                {
                    var start:Vector3D = new Vector3D(-1, -angle * (1 + crossing), gap);
                    var b:Capsule = new Capsule(start, new Vector3D(1, angle * (1 - crossing), gap), radius);
                    assertEquals("angle " + angle + ", gap " + gap, gap <= 2 * radius, intersects(a, b));
                }
            }
        }

        /** A capsule without a radius has no room for rounding where it enters the box. */
        [Test]
        public function findsSegmentsThatPierceBoxes():void
        {
            var random:SeededRandom = new SeededRandom(29);
            var structures:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 2000; i++)
            {
                var box:Box = structures.box(1, 3);
                if (random.chance(0.2))
                {
                    box.halfX = 0;
                }
                var direction:Vector3D = random.chance(0.2) ? box.axisX : structures.direction();
                var through:Vector3D = box.center;
                var before:Number = random.between(0.1, 5);
                var after:Number = random.between(0.1, 5);
                var segment:Capsule = new Capsule(
                        new Vector3D(through.x - before * direction.x, through.y - before * direction.y, through.z - before * direction.z),
                        new Vector3D(through.x + after * direction.x, through.y + after * direction.y, through.z + after * direction.z), 0);
                assertTrue("pair " + i, intersects(segment, box));
            }
        }

        private static function doExtentsMeet(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var extents:Vector.<Number> = new Vector.<Number>(12, true);
            a.extentsInto(extents);
            b.extentsInto(extents, 6);
            for (var i:int = 0; i < 6; i += 2)
            {
                if (extents[i] > extents[i + 7] || extents[i + 6] > extents[i + 1])
                {
                    return false;
                }
            }
            return true;
        }
    }
}
