package starlogo.intersection
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;

    public class IntersectsTest
    {
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX];

        /** Where pairs are put: no coordinate is 0, or another's. */
        private static const PLACE:Vector3D = new Vector3D(3, -5, 11);

        /** Turns that exchange axes and change their signs. */
        private static const TURNS:Array = [
                [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
                [0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1],
                [0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1],
                [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
                [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
                [0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1]];

        [Test]
        public function findsEveryPairInBothOrders():void
        {
            var random:RandomStructures = new RandomStructures(new SeededRandom(3));
            for each (var kindA:int in KINDS)
            {
                for each (var kindB:int in KINDS)
                {
                    var a:BoundingStructure = random.ofKind(kindA, 1, 0);
                    var b:BoundingStructure = random.ofKind(kindB, 1, 0);
                    assertTrue(a + " and " + b, intersects(a, b));
                    b.translate(new Vector3D(5, 0, 0));
                    assertFalse(a + " and far " + b, intersects(a, b));
                }
            }
        }

        [Test]
        public function refusesCylinders():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1);
            var sphere:Sphere = new Sphere(new Vector3D(), 1);
            for each (var pair:Array in [[cylinder, sphere], [sphere, cylinder], [cylinder, cylinder]])
            {
                try
                {
                    intersects(pair[0], pair[1]);
                }
                catch (error:ArgumentError)
                {
                    assertTrue(error.message, error.message.indexOf("Cylinder") >= 0);
                    continue;
                }
                fail("no error for " + pair);
            }
        }

        [Test(expects="TypeError")]
        public function refusesNullAsFirst():void
        {
            intersects(null, new Sphere(new Vector3D(), 1));
        }

        [Test(expects="TypeError")]
        public function refusesNullAsSecond():void
        {
            intersects(new Sphere(new Vector3D(), 1), null);
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

        [Test]
        public function touchingSphereSphere():void
        {
            checkTouch("side by side", ball(0, 0, 0, 2), ball(5, 0, 0, 3), new Vector3D(1, 0, 0));
            checkTouch("askew", ball(0, 0, 0, 2), ball(2, 3, 6, 5), new Vector3D(2, 3, 6));
            checkTouch("a point", ball(0, 0, 0, 5), ball(3, 4, 0, 0), new Vector3D(3, 4, 0));
        }

        [Test]
        public function touchingSphereCapsule():void
        {
            checkTouch("beside the middle", ball(0, 0, 0, 2), rod(-4, 4, 3, 8, 4, -6, 2), new Vector3D(0, 4, 0));
            checkTouch("before the start", ball(0, 0, 0, 2), rod(3, 4, 0, 9, 5, 1, 3), new Vector3D(3, 4, 0));
            checkTouch("behind the end", ball(0, 0, 0, 2), rod(9, 5, 1, 3, 4, 0, 3), new Vector3D(3, 4, 0));
        }

        [Test]
        public function touchingSphereBox():void
        {
            for each (var corner:Vector3D in [new Vector3D(1, 1, 1), new Vector3D(-1, 1, 1), new Vector3D(1, -1, 1), new Vector3D(1, 1, -1)])
            {
                checkTouch("face x", ball(corner.x * 2, 0.5, 0.5, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(-corner.x, 0, 0));
                checkTouch("face y", ball(0.5, corner.y * 3, 0.5, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(0, -corner.y, 0));
                checkTouch("face z", ball(0.5, 0.5, corner.z * 4, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(0, 0, -corner.z));
                checkTouch("edge", ball(corner.x * 4, corner.y * 6, 0.5, 5), block(0, 0, 0, 1, 2, 3), new Vector3D(-3 * corner.x, -4 * corner.y, 0));
                checkTouch("vertex", ball(corner.x * 3, corner.y * 5, corner.z * 9, 7), block(0, 0, 0, 1, 2, 3), new Vector3D(-2 * corner.x, -3 * corner.y, -6 * corner.z));
            }
        }

        [Test]
        public function touchingCapsuleCapsule():void
        {
            checkTouch("crossed", rod(-4, 0, 0, 4, 0, 0, 2), rod(0, 3, -4, 0, 3, 4, 1), new Vector3D(0, 1, 0));
            checkTouch("side by side", rod(0, 0, 0, 4, 0, 0, 2), rod(3, 3, 4, 9, 3, 4, 3), new Vector3D(0, 3, 4));
            checkTouch("one behind the other", rod(0, 0, 0, 4, 0, 0, 2), rod(9, 0, 0, 12, 0, 0, 3), new Vector3D(1, 0, 0));
            checkTouch("end to side", rod(-4, 0, 0, 4, 0, 0, 2), rod(1, 5, 0, 1, 9, 0, 3), new Vector3D(0, 1, 0));
            checkTouch("end to end", rod(-4, 0, 0, 0, 0, 0, 2), rod(2, 3, 6, 9, 9, 9, 5), new Vector3D(2, 3, 6));
        }

        [Test]
        public function touchingCapsuleBox():void
        {
            checkTouch("along a face", rod(-2, 0.5, 4, 2, 0.5, 4, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(0, 0, -1));
            checkTouch("across a face", rod(-9, -8, 4, 9, 8, 4, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(0, 0, -1));
            checkTouch("end on a face", rod(0.5, 4, 0.5, 0.5, 9, 0.5, 2), block(0, 0, 0, 1, 2, 3), new Vector3D(0, -1, 0));
            checkTouch("along an edge", rod(4, 6, -2, 4, 6, 9, 5), block(0, 0, 0, 1, 2, 3), new Vector3D(-3, -4, 0));
            checkTouch("across an edge", rod(0, 9, 0.5, 8, 3, 0.5, 5), block(0, 0, 0, 1, 2, 3), new Vector3D(-3, -4, 0));
            checkTouch("across a vertex", rod(0, 7, 9, 6, 3, 9, 7), block(0, 0, 0, 1, 2, 3), new Vector3D(-2, -3, -6));
            checkTouch("end on a vertex", rod(3, 5, 9, 9, 9, 9, 7), block(0, 0, 0, 1, 2, 3), new Vector3D(-2, -3, -6));
        }

        [Test]
        public function touchingBoxBox():void
        {
            var half:Number = Math.SQRT1_2;
            var slanted:Box = new Box(new Vector3D(1 + 4, 2 + 4, 0), new Vector3D(half, -half, 0), new Vector3D(0.5, 0.5, half), new Vector3D(0.5, 0.5, -half), 3, 4, 4);
            checkTouch("faces x", block(0, 0, 0, 1, 2, 3), block(5, 1, 1, 4, 2, 2), new Vector3D(1, 0, 0));
            checkTouch("faces y", block(0, 0, 0, 1, 2, 3), block(1, 6, 1, 2, 4, 2), new Vector3D(0, 1, 0));
            checkTouch("faces z", block(0, 0, 0, 1, 2, 3), block(1, 1, 7, 2, 2, 4), new Vector3D(0, 0, 1));
            checkTouch("edge on a face", block(0, 0, 0, 1, 2, 3), turned(8, 0.5, 0.5, 5, 5, 1), new Vector3D(1, 0, 0));
            checkTouch("face on an edge", turned(8, 0.5, 0.5, 5, 5, 1), block(0, 0, 0, 1, 2, 3), new Vector3D(-1, 0, 0));
            checkTouch("crossed edges", block(0, 0, 0, 1, 2, 3), slanted, new Vector3D(1, 1, 0));
            checkTouch("vertices", block(0, 0, 0, 1, 2, 3), block(5, 6, 7, 4, 4, 4), new Vector3D(1, 1, 1));
        }

        /**
         * Two that touch collide, in both orders and in every place and turn. Moved apart they do not, moved together they do.
         *
         * @param a where it touches b
         * @param b where it touches a
         * @param away the direction in which b is parted from a
         */
        private static function checkTouch(name:String, a:BoundingStructure, b:BoundingStructure, away:Vector3D):void
        {
            var random:RandomStructures = new RandomStructures(new SeededRandom(7));
            away.normalize();
            for (var i:int = 0; i < TURNS.length + 20; i++)
            {
                // single precision, which a player's matrices may have, leaves touch alone where it only exchanges axes
                var isExact:Boolean = i < TURNS.length;
                var turn:Matrix3D = isExact ? new Matrix3D(Vector.<Number>(TURNS[i])) : turnOf(random);
                for each (var gap:Number in isExact ? [0, -1e-9, 1e-9] : [-1e-4, 1e-4])
                {
                    var moved:BoundingStructure = b.clone().translate(new Vector3D(away.x * gap, away.y * gap, away.z * gap)).rotate(turn).translate(PLACE);
                    var still:BoundingStructure = a.clone().rotate(turn).translate(PLACE);
                    var text:String = name + ", turn " + i + ", gap " + gap;
                    assertEquals(text, gap <= 0, intersects(still, moved));
                    assertEquals(text + ", the other way round", gap <= 0, intersects(moved, still));
                }
            }
        }

        private static function turnOf(random:RandomStructures):Matrix3D
        {
            var axes:Vector.<Vector3D> = random.frame();
            return new Matrix3D(new <Number>[
                        axes[0].x, axes[0].y, axes[0].z, 0, axes[1].x, axes[1].y, axes[1].z, 0, axes[2].x, axes[2].y, axes[2].z, 0, 0, 0, 0, 1]);
        }

        private static function ball(x:Number, y:Number, z:Number, radius:Number):Sphere
        {
            return new Sphere(new Vector3D(x, y, z), radius);
        }

        private static function rod(startX:Number, startY:Number, startZ:Number, endX:Number, endY:Number, endZ:Number, radius:Number):Capsule
        {
            return new Capsule(new Vector3D(startX, startY, startZ), new Vector3D(endX, endY, endZ), radius);
        }

        private static function block(x:Number, y:Number, z:Number, halfX:Number, halfY:Number, halfZ:Number):Box
        {
            return new Box(new Vector3D(x, y, z), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), halfX, halfY, halfZ);
        }

        /** A box that is turned about z by the angle of a triangle with sides of 3, 4 and 5. */
        private static function turned(x:Number, y:Number, z:Number, halfX:Number, halfY:Number, halfZ:Number):Box
        {
            return new Box(new Vector3D(x, y, z), new Vector3D(0.6, 0.8, 0), new Vector3D(-0.8, 0.6, 0), new Vector3D(0, 0, 1), halfX, halfY, halfZ);
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
