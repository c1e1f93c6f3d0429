package starlogo.bounding
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.intersects;
    import support.Structures;
    import support.assertThrows;
    import support.create;

    use namespace engine;

    /** What every bounding structure promises. */
    public class BoundingStructureTest
    {
        private static const X:Vector3D = new Vector3D(1, 0, 0);
        private static const Y:Vector3D = new Vector3D(0, 1, 0);
        private static const Z:Vector3D = new Vector3D(0, 0, 1);

        [Test]
        public function volumesAndSurfacesAreWhereTheyShouldBe():void
        {
            var capsule:Capsule = new Capsule(at(0, 0, 0), at(0, 0, 2), 1);
            var cylinder:Cylinder = new Cylinder(at(0, 0, 0), at(0, 0, 2), 1);
            var box:Box = new Box(at(1, 0, 0), at(0.6, 0.8, 0), at(-0.8, 0.6, 0), Z, 1, 2, 3);
            // each with its volume, a point of its surface and one beyond
            var rows:Array = [[new Sphere(at(1, 0, 0), 2), 32 / 3 * Math.PI, at(3 + 1e-6, 0, 0), at(3 + 1e-5, 0, 0)],
                    [new Sphere(at(1, 2, 3), 0), 0, at(1, 2, 3), at(1, 2, 3 + 1e-9)],
                    [capsule, 10 / 3 * Math.PI, at(0.6, 0, 2.8), at(0.61, 0, 2.81)],
                    [capsule, 10 / 3 * Math.PI, at(0, 0, -1), at(0, 0, 3.0001)],
                    [new Capsule(at(1, 1, 1), at(1, 1, 1), 0.5), Math.PI / 6, at(1, 1.5, 1), at(1, 1.51, 1)],
                    [new Capsule(at(0, 0, 0), at(1, 0, 0), 0), 0, at(0.5, 0, 0), at(0.5, 0, 0.1)],
                    [cylinder, 2 * Math.PI, at(0.6, -0.8, 2), at(0, 0, 2.0001)],
                    [cylinder, 2 * Math.PI, at(1, 0, 0), at(0, 0, -0.0001)],
                    [cylinder, 2 * Math.PI, at(1, 0, 1), at(0, 1.0001, 1)],
                    [new Cylinder(at(1, 1, 1), at(1, 1, 1), 0.5), 0, at(1, 1, 1), at(1, 1.1, 1)],
                    [box, 48, at(0, 2, 3), at(0, 2.02, 3)],
                    [box, 48, at(1.6, 0.8, 0), at(1.61, 0.81, 0)],
                    [new Box(at(0, 0, 2), X, Y, Z, 1, 1, 0), 0, at(1, -1, 2), at(0, 0, 2.0001)]];
            for each (var row:Array in rows)
            {
                var structure:BoundingStructure = row[0];
                assertNear(structure + ", volume", row[1], structure.volume, 1e-12);
                assertTrue(structure + " contains " + row[2], structure.contains(row[2]));
                assertFalse(structure + " contains " + row[3], structure.contains(row[3]));
            }
        }

        [Test]
        public function oneOfAGamesOwnClassSaysWhichClassItIs():void
        {
            var said:String = String(new BoundingStructure(BoundingStructure.OTHER));
            assertTrue(said, /^a structure of class (starlogo\.bounding\.)?BoundingStructure$/.test(said));
        }

        [Test]
        public function oneOfAGamesOwnClassIsNoneOfTheEnginesKinds():void
        {
            for each (var kind:int in [BoundingStructure.SPHERE, BoundingStructure.CAPSULE, BoundingStructure.BOX, BoundingStructure.OTHER])
            {
                assertThrows(ArgumentError, /no intersection test/, intersects, new BoundingStructure(kind), new Box(at(0, 0, 0), X, Y, Z, 1, 1, 1));
            }
        }

        [Test]
        public function whatIsNoStructureIsRefused():void
        {
            for each (var wrong:Number in [-1, NaN, Infinity])
            {
                for each (var row:Array in [[Sphere, at(0, 0, 0), wrong], [Capsule, at(0, 0, 0), X, wrong], [Cylinder, at(0, 0, 0), X, wrong],
                            [Box, at(0, 0, 0), X, Y, Z, wrong, 1, 1], [Box, at(0, 0, 0), X, Y, Z, 1, wrong, 1], [Box, at(0, 0, 0), X, Y, Z, 1, 1, wrong]])
                {
                    assertThrows.apply(null, [RangeError, new RegExp(String(wrong)), create].concat(row));
                }
            }
            for each (row in [[Sphere, at(0, NaN, 0), 1], [Capsule, at(0, 0, 0), at(0, 0, NaN), 1], [Cylinder, at(0, 0, 0), at(0, 0, NaN), 1],
                        [Box, at(0, 0, 0), at(NaN, 0, 0), Y, Z, 1, 1, 1]])
            {
                assertThrows.apply(null, [RangeError, /./, create].concat(row));
            }
            for each (row in [[Sphere, null, 1], [Capsule, null, X, 1], [Capsule, X, null, 1], [Cylinder, null, X, 1], [Cylinder, X, null, 1],
                        [Box, null, X, Y, Z, 1, 1, 1]])
            {
                assertThrows.apply(null, [ArgumentError, /./, create].concat(row));
            }
            for each (var axes:Array in [[null, Y, Z], [X, null, Z], [X, Y, null], [X, X, Z], [at(2, 0, 0), Y, Z], [X, at(0.01, 1, 0), Z],
                        [X, Y, at(0, 0, 0)]])
            {
                assertThrows(ArgumentError, /./, create, Box, at(0, 0, 0), axes[0], axes[1], axes[2], 1, 1, 1);
            }
        }

        [Test]
        public function structuresHaveLimits():void
        {
            var structure:BoundingStructure;
            for each (var wrong:Number in [1e78, 1e-100])
            {
                for each (var row:Array in [[Sphere, at(0, 0, 0), wrong], [Capsule, at(0, 0, 0), at(wrong, 0, 0), 0], [Capsule, X, X, wrong],
                            [Cylinder, X, X, wrong], [Box, at(0, 0, 0), X, Y, Z, 0, 0, wrong]])
                {
                    assertThrows.apply(null, [RangeError, new RegExp("1e" + (wrong < 1 ? "-100" : ".?78")), create].concat(row));
                }
            }
            // not to 0 either
            for each (structure in [new Sphere(at(0, 0, 0), 1e-69), new Capsule(at(0, 0, 0), at(1e-60, 0, 0), 0), new Box(at(0, 0, 0), X, Y, Z, 0, 0, 1e-60)])
            {
                assertThrows(RangeError, /e-30[01]/, structure.scale, 1e-300);
            }
            // thin ones are not small
            new Capsule(X, Y, 1e-100);
            new Box(X, X, Y, Z, 1, 0, 1e-200);
            for each (row in [[Sphere, X, 1], [Capsule, X, Y, 1], [Cylinder, X, Y, 1], [Box, X, X, Y, Z, 1, 2, 3]])
            {
                structure = create.apply(null, row);
                var before:String = structure.toString();
                assertThrows(RangeError, /e.?308|Infinity/, structure.scale, 1e308);
                assertThrows(RangeError, /e-30[89]/, structure.scale, 1e-308);
                assertThrows(RangeError, /1e.?80/, structure.translate, at(0, 1e80, 0));
                assertEquals(before, structure.toString());
            }
        }

        // within the limits, and a little beyond them, as an agent's size may place them
        [Test]
        public function capsulesOfAnySizeThatCrossTouch():void
        {
            for each (var size:Number in [1e-70, 1e-30, 1, 1e30, 1e70])
            {
                for each (var factor:Number in [1e-6, 1, 1e6])
                {
                    var placement:Placement = new Placement();
                    placement.size = factor;
                    var along:Capsule = new Capsule(at(-size, 0, 0), at(size, 0, 0), 0.1 * size);
                    var across:Capsule = new Capsule(at(0, -size, 0.19 * size), at(0, size, 0.19 * size), 0.1 * size);
                    var beside:Capsule = new Capsule(at(0, -size, 0.21 * size), at(0, size, 0.21 * size), 0.1 * size);
                    var box:Box = new Box(at(0, 0, 0), X, Y, Z, size, 0.1 * size, 0.1 * size);
                    along.place(placement, along);
                    box.place(placement, box);
                    assertTrue(size + " * " + factor, intersects(along, across.place(placement)));
                    assertFalse(size + " * " + factor, intersects(along, beside.place(placement)));
                    assertTrue(size + " * " + factor, intersects(box, across.place(placement)));
                    assertFalse(size + " * " + factor, intersects(box, beside.place(placement)));
                }
            }
        }

        private static function at(x:Number, y:Number, z:Number):Vector3D
        {
            return new Vector3D(x, y, z);
        }

        [Test]
        public function clonesShareNothing():void
        {
            for each (var structure:BoundingStructure in Structures.samples())
            {
                var before:String = String(Structures.numbersOf(structure));
                var copy:BoundingStructure = structure.clone();
                assertEquals(before, String(Structures.numbersOf(copy)));
                copy.scale(3).rotate(turn(10, 20, 30)).translate(new Vector3D(4, 5, 6));
                assertEquals(before, String(Structures.numbersOf(structure)));
                assertFalse(before == String(Structures.numbersOf(copy)));
            }
        }

        [Test]
        public function constructorsCopyTheirVectors():void
        {
            var point:Vector3D = new Vector3D(1, 2, 3);
            var other:Vector3D = new Vector3D(3, 2, 1);
            var sphere:Sphere = new Sphere(point, 1);
            var capsule:Capsule = new Capsule(point, other, 1);
            var cylinder:Cylinder = new Cylinder(point, other, 1);
            var axis:Vector3D = X.clone();
            var box:Box = new Box(point, axis, Y, Z, 1, 2, 3);
            point.x = axis.x = 9;
            assertEquals(1, box.center.x);
            assertEquals(1, box.axisX.x);
            point.x = other.x = 9;
            assertEquals(1, sphere.center.x);
            assertEquals(1, capsule.start.x);
            assertEquals(3, capsule.end.x);
            assertEquals(1, cylinder.start.x);
            assertEquals(3, cylinder.end.x);
        }

        [Test]
        public function refusedCallsChangeNothing():void
        {
            var sheared:Matrix3D = new Matrix3D(Vector.<Number>([1, 0, 0, 0, 0.1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]));
            var scaled:Matrix3D = new Matrix3D();
            scaled.appendScale(2, 2, 2);
            var moved:Matrix3D = new Matrix3D();
            moved.appendTranslation(0, 0, 1);
            for each (var structure:BoundingStructure in Structures.samples())
            {
                var before:String = String(Structures.numbersOf(structure));
                for each (var factor:Number in [0, -1, NaN, Infinity])
                {
                    assertThrows(RangeError, /./, structure.scale, factor);
                }
                assertThrows(RangeError, /from 1e-140 to 1e140: -3/, structure.scale, -3);
                for each (var matrix:Matrix3D in [null, sheared, scaled, moved])
                {
                    assertThrows(ArgumentError, /./, structure.rotate, matrix);
                }
                assertThrows(ArgumentError, /./, structure.translate, null);
                assertThrows(RangeError, /./, structure.translate, new Vector3D(0, NaN, 0));
                assertThrows(RangeError, /./, structure.translate, new Vector3D(0, 0, -Infinity));
                assertEquals(before, String(Structures.numbersOf(structure)));
            }
        }

        [Test]
        public function containsItsSurfaceAndNothingBeyond():void
        {
            var random:SeededRandom = new SeededRandom(5);
            for each (var structure:BoundingStructure in Structures.samples())
            {
                for (var i:int = 0; i < 300; i++)
                {
                    assertTrue(structure + " " + i, structure.contains(Structures.pointOf(structure, random, random.next())));
                    assertTrue(structure + " " + i, structure.contains(Structures.pointOf(structure, random, 1)));
                }
                var far:Vector3D = Structures.pointOf(structure, random, 1);
                far.x += 20;
                assertFalse(structure.contains(far));
            }
        }

        [Test]
        public function placesIntoAnExistingStructure():void
        {
            var placement:Placement = standing(0.5, [20, 30, 40], 1, 2, 3);
            for each (var structure:BoundingStructure in Structures.samples())
            {
                var before:String = String(Structures.numbersOf(structure));
                var expected:BoundingStructure = structure.place(placement);
                var out:BoundingStructure = structure.clone().scale(7);
                assertStrictlyEquals(out, structure.place(placement, out));
                assertSame(expected, out, 0);
                assertEquals(before, String(Structures.numbersOf(structure)));
                assertStrictlyEquals(structure, structure.place(placement, structure));
                assertSame(expected, structure, 0);
            }
        }

        [Test]
        public function refusesToPlaceIntoAnotherKind():void
        {
            var samples:Vector.<BoundingStructure> = Structures.samples();
            for (var i:int = 0; i < samples.length; i++)
            {
                var other:BoundingStructure = samples[(i + 1) % samples.length];
                if (other.kind == samples[i].kind)
                {
                    // further structures have the kind of a Hull, and may be exchanged
                    continue;
                }
                var before:String = String(Structures.numbersOf(other));
                assertThrows(ArgumentError, /out must be .* of the same kind as a /, samples[i].place, new Placement(), other);
                assertEquals(before, String(Structures.numbersOf(other)));
            }
            // a structure of a game's own has the kind of a Cylinder
            for each (var structure:BoundingStructure in samples)
            {
                assertThrows(ArgumentError, /out must be .*: one of the game/, structure.place, new Placement(), new OwnStructure());
            }
        }

        [Test]
        public function turnedExtentsAreThoseOfThePlacedStructure():void
        {
            var random:SeededRandom = new SeededRandom(10);
            var turned:Vector.<Number> = new Vector.<Number>(6, true);
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            var compared:int = 0;
            for each (var structure:BoundingStructure in Structures.samples())
            {
                if (structure is Cylinder)
                {
                    continue;
                }
                for (var i:int = 0; i < 40; i++)
                {
                    var angles:Array = random.pick([[0, 0, 0], [random.between(0, 360), 0, 0],
                                [random.between(0, 360), random.between(0, 360), random.between(0, 360)]]);
                    var placement:Placement = standing(random.logBetween(0.1, 10), angles, random.normal(), random.normal(), random.normal());
                    structure.findPlacedBox(placement, turned);
                    structure.place(placement).extentsInto(extents);
                    var at:Array = [placement.x, placement.y, placement.z];
                    for (var axis:int = 0; axis < 3; axis++)
                    {
                        var middle:Number = at[axis] + turned[axis];
                        assertTrue(structure + " from", Math.abs(middle - turned[axis + 3] - extents[2 * axis]) < 1e-11);
                        assertTrue(structure + " to", Math.abs(middle + turned[axis + 3] - extents[2 * axis + 1]) < 1e-11);
                        compared++;
                    }
                }
            }
            assertTrue(compared > 300);
        }

        [Test]
        public function extentsAreTight():void
        {
            var random:SeededRandom = new SeededRandom(9);
            var extents:Vector.<Number> = new Vector.<Number>(8, true);
            for each (var structure:BoundingStructure in Structures.samples())
            {
                structure.rotate(turn(random.between(0, 360), random.between(0, 360), random.between(0, 360)));
                extents[0] = extents[7] = 77;
                structure.extentsInto(extents, 1);
                assertEquals(77, extents[0]);
                assertEquals(77, extents[7]);
                var reached:Array = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
                for (var i:int = 0; i < 4000; i++)
                {
                    var point:Vector3D = Structures.pointOf(structure, random, 1);
                    reached = [Math.min(reached[0], point.x), Math.max(reached[1], point.x), Math.min(reached[2], point.y),
                            Math.max(reached[3], point.y), Math.min(reached[4], point.z), Math.max(reached[5], point.z)];
                }
                for (i = 0; i < 6; i++)
                {
                    var missing:Number = i % 2 == 0 ? reached[i] - extents[i + 1] : extents[i + 1] - reached[i];
                    assertTrue(structure + " extent " + i + ": " + missing, missing >= 0 && missing < 0.05);
                }
            }
        }

        [Test]
        public function stillContainsWhatWentThroughTheSameSinglePrecisionMatrix():void
        {
            var random:SeededRandom = new SeededRandom(21);
            for each (var sample:BoundingStructure in Structures.samples())
            {
                for (var i:int = 0; i < 50; i++)
                {
                    var rotation:Matrix3D = turn(random.between(0, 360), random.between(0, 360), random.between(0, 360));
                    rotation = Structures.inSinglePrecision(rotation);
                    var structure:BoundingStructure = sample.clone().rotate(rotation);
                    for (var j:int = 0; j < 20; j++)
                    {
                        var point:Vector3D = rotation.transformVector(Structures.pointOf(sample, random, 1));
                        point = Structures.vectorInSinglePrecision(point);
                        assertTrue(structure + ", rotation " + i + ", point " + j, structure.contains(point));
                    }
                }
            }
        }

        [Test(expects="flash.errors.IllegalOperationError")]
        public function isAbstract():void
        {
            new BoundingStructure(BoundingStructure.SPHERE).scale(2);
        }

        private static function turn(heading:Number, pitch:Number, roll:Number):Matrix3D
        {
            var matrix:Matrix3D = new Matrix3D();
            matrix.appendRotation(roll, Vector3D.X_AXIS);
            matrix.appendRotation(pitch, Vector3D.Y_AXIS);
            matrix.appendRotation(heading, Vector3D.Z_AXIS);
            return matrix;
        }

        private static function standing(size:Number, angles:Array, x:Number, y:Number, z:Number):Placement
        {
            var placement:Placement = new Placement();
            placement.size = size;
            placement.setRotation(angles[0], angles[1], angles[2]);
            placement.x = x;
            placement.y = y;
            placement.z = z;
            return placement;
        }

        private static function assertSame(expected:BoundingStructure, actual:BoundingStructure, tolerance:Number):void
        {
            var expectedNumbers:Array = Structures.numbersOf(expected);
            var actualNumbers:Array = Structures.numbersOf(actual);
            for (var i:int = 0; i < expectedNumbers.length; i++)
            {
                assertNear(expected + " number " + i, expectedNumbers[i], actualNumbers[i], tolerance);
            }
        }

        private static function assertNear(what:String, expected:Number, actual:Number, tolerance:Number):void
        {
            assertTrue(what + ": " + actual + " instead of " + expected, Math.abs(actual - expected) <= tolerance);
        }
    }
}

import starlogo.bounding.BoundingStructure;

/** Has no tests and no numbers. */
class OwnStructure extends BoundingStructure
{
    public function OwnStructure()
    {
        super(OTHER);
    }

    override public function toString():String
    {
        return "one of the game's own";
    }
}
