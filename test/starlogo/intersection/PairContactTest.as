package starlogo.intersection
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.intersects;

    /** Contacts part what overlaps, and lie in the middle of it. */
    public class PairContactTest
    {
        private static const KINDS:Array = [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX];
        private static const FACED:Array = [BoundingStructure.BOX, BoundingStructure.HULL];
        private static const TOUCHING:Number = 1e-6;

        private var _displacement:RelativeMotion = new RelativeMotion(0);
        private var _touch:ContactPoint = new ContactPoint();

        [Test]
        public function movingAlongTheNormalByTheDepthLeavesATouch():void
        {
            var random:SeededRandom = new SeededRandom(401);
            var shapes:RandomStructures = new RandomStructures(random);
            var parted:int = 0;
            while (parted < 10000)
            {
                var a:BoundingStructure = shapes.ofKind(random.pick(KINDS), 1, 0.7);
                var b:BoundingStructure = shapes.ofKind(random.pick(KINDS), 1, 0.7);
                if (intersects(a, b))
                {
                    StructurePairs.findContact(a, b, _displacement, _touch);
                    checkParts("overlap " + parted, a, b);
                    parted++;
                }
            }
        }

        [Test]
        public function theFirstMovesUpwardsWhereNothingElseIsNearer():void
        {
            var ball:Sphere = new Sphere(new Vector3D(1, 2, 3), 0.5);
            checkNormal(ball, ball, 0, 0, 1, 1);
            var level:Capsule = new Capsule(new Vector3D(0, 2, 3), new Vector3D(3, 2, 3), 0.25);
            checkNormal(level, ball, 0, 0, 1, 0.75);
            checkNormal(ball, level, 0, 0, -1, 0.75);
            checkNormal(level, level, 0, 0, 1, 0.5);
            var upright:Capsule = new Capsule(new Vector3D(1, 2, 0), new Vector3D(1, 2, 9), 0.25);
            checkNormal(upright, ball, 1, 0, 0, 0.75);
            // segments that cross: at right angles to both, to the side where the first one's middle is
            var across:Capsule = new Capsule(new Vector3D(1, 0, 3), new Vector3D(1, 3, 3), 0.25);
            checkNormal(across, level, 0, 0, 1, 0.5, true);
        }

        // An edge as short as this has a cross product of which rounding has left few digits, or none.
        [Test]
        public function normalsAtTheShortestEdgesAreUnitVectors():void
        {
            var random:SeededRandom = new SeededRandom(402);
            var shapes:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 500; i++)
            {
                var tiny:Vector3D = shapes.direction();
                tiny.scaleBy(random.logBetween(1e-170, 1e-140));
                var capsule:Capsule = capsuleAround(shapes.direction());
                var axes:Vector.<Vector3D> = shapes.frame();
                var stick:Box = new Box(new Vector3D(), axes[0], axes[1], axes[2], tiny.length, 0.5, random.pick([tiny.length, 0.5]));
                for each (var short:BoundingStructure in [new Capsule(new Vector3D(), tiny, 0.5), stick])
                {
                    StructurePairs.findContact(short, capsule, _displacement, _touch);
                    var length:Number = Math.sqrt(_touch.normalX * _touch.normalX + _touch.normalY * _touch.normalY + _touch.normalZ * _touch.normalZ);
                    assertTrue(short + " and " + capsule + ": " + length, Math.abs(length - 1) < 1e-15);
                }
            }
        }

        // Across the two the way out is as short as their thickness. Their cross product has lost half of its digits.
        [Test]
        public function needlesThatAreNearlyParallelPartByTheirThickness():void
        {
            var random:SeededRandom = new SeededRandom(404);
            var shapes:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 500; i++)
            {
                var axes:Vector.<Vector3D> = shapes.frame();
                var thickness:Number = random.logBetween(1e-13, 1e-11);
                var first:Array = needles(new Vector3D(), axes[0], axes[1], axes[2], thickness);
                var tilt:Number = random.logBetween(1e-9, 1e-7);
                var middle:Vector3D = sum(new Vector3D(), axes[2], thickness);
                var second:Array = needles(middle, sum(axes[0], axes[1], tilt), sum(axes[1], axes[0], -tilt), axes[2], thickness);
                for each (var a:BoundingStructure in first)
                {
                    for each (var b:BoundingStructure in second)
                    {
                        StructurePairs.findContact(a, b, _displacement, _touch);
                        assertTrue(a + " and " + b + ": " + _touch.depth, _touch.depth <= thickness + 1e-9);
                    }
                }
            }
        }

        // A capsule and a box along an axis. The box is flat.
        private static function needles(middle:Vector3D, axisX:Vector3D, axisY:Vector3D, axisZ:Vector3D, thickness:Number):Array
        {
            return [new Capsule(sum(middle, axisX, -1), sum(middle, axisX, 1), thickness), new Box(middle, axisX, axisY, axisZ, 1, 0, thickness)];
        }

        private static function sum(a:Vector3D, b:Vector3D, factor:Number):Vector3D
        {
            return new Vector3D(a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z);
        }

        // Of two directions without a certain perpendicular the longer one counts.
        [Test]
        public function theShortestCapsuleIsMovedLikeABall():void
        {
            var random:SeededRandom = new SeededRandom(403);
            var shapes:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 500; i++)
            {
                var tiny:Vector3D = shapes.direction();
                tiny.scaleBy(random.logBetween(1e-165, 1e-140));
                var capsule:Capsule = capsuleAround(shapes.direction());
                StructurePairs.findContact(new Capsule(new Vector3D(), tiny, 0.5), capsule, _displacement, _touch);
                assertTrue(tiny + " and " + capsule + ": " + _touch.depth, Math.abs(_touch.depth - 0.8) < 1e-12);
            }
        }

        // Its segment leads from the opposite of a direction to the direction.
        private static function capsuleAround(direction:Vector3D):Capsule
        {
            var opposite:Vector3D = direction.clone();
            opposite.negate();
            return new Capsule(opposite, direction, 0.3);
        }

        /** Seen along the normal the sides that touch have nothing in common but for rounding. The middle of one side may be far from the other. */
        [Test]
        public function thePointOfPlatesThatMeetAtTheirBordersIsThere():void
        {
            var plate:Box = new Box(new Vector3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), 0, 1, 1);
            for each (var middle:Vector3D in [new Vector3D(0.5, -1.3000000002, -0.1000000006), new Vector3D(0.4999999, -1.3000000002, -0.1000000006)])
            {
                var other:Box = new Box(middle, new Vector3D(1, 0, 0), new Vector3D(0, 0.6, 0.8), new Vector3D(0, -0.8, 0.6), 0.5, 0.5, 1e-9);
                StructurePairs.findContact(plate, other, _displacement, _touch);
                var around:Sphere = new Sphere(new Vector3D(_touch.x, _touch.y, _touch.z), _touch.depth + 1e-7);
                assertTrue("the plate is at " + around, intersects(around, plate));
                assertTrue("the other is at " + around, intersects(around, other));
            }
        }

        [Test]
        public function thePointOfTwoFacesIsInTheMiddleOfTheirOverlap():void
        {
            var low:Box = cube(1, 1, 1);
            var from:RelativeMotion = _displacement;
            from.startX = 1.5;
            from.startY = -0.5;
            from.startZ = 1.9;
            StructurePairs.findContact(cube(1, 1, 1), low, _displacement, _touch);
            assertPoint("faces", 0.75, -0.25, 0.95);
            assertNear("depth", 0.1, _touch.depth);
            from.startX = from.startY = 0;
            from.startZ = 1.2;
            StructurePairs.findContact(new Capsule(new Vector3D(-3, 0, 0), new Vector3D(0.5, 0, 0), 0.5), low, _displacement, _touch);
            assertPoint("a capsule on a face", -0.25, 0, 0.85);
            from.startZ = 0.9;
            StructurePairs.findContact(new Capsule(new Vector3D(-3, 0, 0), new Vector3D(0.5, 0, 0), 0.5), low, _displacement, _touch);
            assertPoint("a capsule deep in a face", -0.25, 0, 0.7);
        }

        /** Axes and boxes that are parallel, but for rounding, touch along a part. No end of it is nearer than the other by more than rounding. */
        [Test]
        public function thePointOfAParallelAxisIsInTheMiddleOfWhatIsShared():void
        {
            var random:SeededRandom = new SeededRandom(403);
            var shapes:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 2000; i++)
            {
                var frame:Vector.<Vector3D> = shapes.frame();
                var tilt:Number = random.pick([0, 6e-17, -6e-17, 1e-14, -1e-12]);
                var start:Number = random.between(-2, 0.5);
                var end:Number = random.between(Math.max(start, -1) + 0.2, 3);
                var isAtEdge:Boolean = random.chance();
                var from:Vector3D = place(frame, start, isAtEdge ? 0.8 : 0, 0.8);
                var to:Vector3D = place(frame, end, isAtEdge ? 0.8 : 0, 0.8 + tilt * (end - start));
                var capsule:Capsule = random.chance() ? new Capsule(from, to, 0.5) : new Capsule(to, from, 0.5);
                var box:Box = new Box(new Vector3D(), frame[0], frame[1], frame[2], 1, 0.5, 0.5);
                var other:Capsule = new Capsule(place(frame, -1, 0, 0), place(frame, 1, 0, 0), 0.7);
                var middle:Number = (Math.max(start, -1) + Math.min(end, 1)) / 2;
                for each (var b:BoundingStructure in [box, other])
                {
                    StructurePairs.findContact(capsule, b, _displacement, _touch);
                    assertNear(i + ": " + capsule + " and " + b, middle, along(frame[0]));
                    StructurePairs.findContact(b, capsule, _displacement, _touch);
                    assertNear(i + ": " + b + " and " + capsule, middle, along(frame[0]));
                }
            }
        }

        /** The order of a ridge's ends does not matter, whichever of the two is given first. */
        [Test]
        public function thePointOfTwoRidgesOnALineIsInTheMiddleOfWhatIsShared():void
        {
            for each (var low:Hull in [wedge(0, 4, -1), wedge(4, 0, -1)])
            {
                for each (var high:Hull in [wedge(3, 9, 1), wedge(9, 3, 1)])
                {
                    StructurePairs.findContact(low, high, _displacement, _touch);
                    assertPoint(low + " and " + high, 3.5, 0, 0);
                    StructurePairs.findContact(high, low, _displacement, _touch);
                    assertPoint(high + " and " + low, 3.5, 0, 0);
                }
            }
        }

        // A ridge along x, and below it or above it the rectangle where the wedge ends.
        private static function wedge(from:Number, to:Number, z:Number):Hull
        {
            return new Hull(new <Number>[from, 0, 0, to, 0, 0, from, 1, z, to, 1, z, from, -1, z, to, -1, z]);
        }

        private function along(axis:Vector3D):Number
        {
            return _touch.x * axis.x + _touch.y * axis.y + _touch.z * axis.z;
        }

        private static function place(frame:Vector.<Vector3D>, x:Number, y:Number, z:Number):Vector3D
        {
            return new Vector3D(x * frame[0].x + y * frame[1].x + z * frame[2].x, x * frame[0].y + y * frame[1].y + z * frame[2].y,
                    x * frame[0].z + y * frame[1].z + z * frame[2].z);
        }

        /** A contact's object may have been that of a contact with the ground, or of a model's triangle. */
        [Test]
        public function nothingOfAnEarlierContactIsLeft():void
        {
            var shapes:RandomStructures = new RandomStructures(new SeededRandom(404));
            for each (var kindA:int in KINDS.concat(BoundingStructure.HULL))
            {
                for each (var kindB:int in KINDS.concat(BoundingStructure.HULL))
                {
                    _touch.triangle = 3;
                    _touch.isDeepestOfA = true;
                    _touch.exitBound = 2;
                    StructurePairs.findContact(shapes.ofKind(kindA, 1, 0.1), shapes.ofKind(kindB, 1, 0.1), _displacement, _touch);
                    assertTrue(kindA + " and " + kindB, _touch.triangle == -1 && !_touch.isDeepestOfA && _touch.exitBound == 0);
                }
            }
        }

        /** Contacts take structures up to 1e50, though nothing in a game is as large. */
        [Test]
        public function contactsOfHugeStructuresAreThoseOfSmallOnes():void
        {
            var random:SeededRandom = new SeededRandom(402);
            var shapes:RandomStructures = new RandomStructures(random);
            var huge:ContactPoint = new ContactPoint();
            for each (var size:Number in [Math.pow(2, 40), Math.pow(2, 120), Math.pow(2, 165)])
            {
                var overlapping:int = 0;
                while (overlapping < 300)
                {
                    var a:BoundingStructure = shapes.ofKind(random.pick(FACED), 1, 0.7);
                    var b:BoundingStructure = shapes.ofKind(random.pick(FACED), 1, 0.7);
                    if (intersects(a, b))
                    {
                        StructurePairs.findContact(a, b, _displacement, _touch);
                        StructurePairs.findContact(a.scale(size), b.scale(size), _displacement, huge);
                        assertNear("depth at " + size, _touch.depth, huge.depth / size);
                        assertNear("normal at " + size, 1, _touch.normalX * huge.normalX + _touch.normalY * huge.normalY + _touch.normalZ * huge.normalZ);
                        overlapping++;
                    }
                }
            }
        }

        private function checkParts(name:String, a:BoundingStructure, b:BoundingStructure):void
        {
            var touch:ContactPoint = _touch;
            var normal:Vector3D = new Vector3D(touch.normalX, touch.normalY, touch.normalZ);
            assertNear(name + ": a unit vector", 1, normal.length);
            assertTrue(name + ": depth " + touch.depth, touch.depth >= 0);
            assertTrue(name + ": moved by less, they overlap", intersects(moved(a, normal, Math.max(0, touch.depth - TOUCHING)), b));
            assertFalse(name + ": moved by more, they do not", intersects(moved(a, normal, touch.depth + TOUCHING), b));
            // the point: half the depth from the surface of either
            var dot:Sphere = new Sphere(new Vector3D(touch.x, touch.y, touch.z), TOUCHING);
            assertTrue(name + ": the point is in the first", intersects(moved(a, normal, touch.depth / 2), dot));
            assertTrue(name + ": the point is in the second", intersects(moved(b, normal, -touch.depth / 2), dot));
            assertFalse(name + ": on the surface of the first", intersects(moved(a, normal, touch.depth / 2 + 3 * TOUCHING), dot));
            assertFalse(name + ": on the surface of the second", intersects(moved(b, normal, -touch.depth / 2 - 3 * TOUCHING), dot));
        }

        private function checkNormal(a:BoundingStructure, b:BoundingStructure, x:Number, y:Number, z:Number, depth:Number,
                orOpposite:Boolean = false):void
        {
            StructurePairs.findContact(a, b, _displacement, _touch);
            var sign:Number = orOpposite && _touch.normalX * x + _touch.normalY * y + _touch.normalZ * z < 0 ? -1 : 1;
            assertNear(a + " in " + b, x, sign * _touch.normalX);
            assertNear(a + " in " + b, y, sign * _touch.normalY);
            assertNear(a + " in " + b, z, sign * _touch.normalZ);
            assertNear(a + " in " + b, depth, _touch.depth);
            checkParts(a + ", " + b, a, b);
        }

        private function assertPoint(name:String, x:Number, y:Number, z:Number):void
        {
            assertNear(name, x, _touch.x);
            assertNear(name, y, _touch.y);
            assertNear(name, z, _touch.z);
        }

        private static function assertNear(name:String, expected:Number, actual:Number):void
        {
            assertTrue(name + ": " + actual + ", not " + expected, Math.abs(actual - expected) <= 1e-8);
        }

        private static function moved(structure:BoundingStructure, direction:Vector3D, distance:Number):BoundingStructure
        {
            return structure.clone().translate(new Vector3D(distance * direction.x, distance * direction.y, distance * direction.z));
        }

        private static function cube(halfX:Number, halfY:Number, halfZ:Number):Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, halfX, halfY, halfZ);
        }
    }
}
