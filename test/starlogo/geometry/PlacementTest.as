package starlogo.geometry
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Sphere;
    import starlogo.engine;

    use namespace engine;

    public class PlacementTest
    {
        private static const ROUNDING:Number = 1e-12;

        private var _random:SeededRandom = new SeededRandom(2718);

        [Test]
        public function rollThenPitchThenHeading():void
        {
            var placement:Placement = new Placement();
            // [heading, pitch, roll, the images of the axes]
            for each (var each:Array in [[0, 0, 0, "1 0 0, 0 1 0, 0 0 1"], [90, 0, 0, "0 1 0, -1 0 0, 0 0 1"], [0, 90, 0, "0 0 -1, 0 1 0, 1 0 0"],
                        [0, 0, 90, "1 0 0, 0 0 1, 0 -1 0"], [90, 90, 90, "0 0 -1, 0 1 0, 1 0 0"], [180, 0, 90, "-1 0 0, 0 0 1, 0 1 0"]])
            {
                placement.setRotation(each[0], each[1], each[2]);
                var images:Array = [Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS].map(function(axis:Vector3D, ...rest):String
                    {
                        var to:Vector3D = new Vector3D();
                        placement.rotate(axis, to);
                        return [to.x + 0, to.y + 0, to.z + 0].join(" ");
                    });
                assertEquals(each.slice(0, 3).join(), each[3], images.join(", "));
            }
        }

        [Test]
        public function comesBackFromAnglesQuaternionMatrixAndNumbers():void
        {
            var angles:Vector3D = new Vector3D();
            var numbers:Vector.<Number> = new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
            for (var i:int = 0; i < 500; i++)
            {
                var from:Placement = randomPlacement(i % 5 == 0 ? 90 : 1e-9);
                var to:Placement = new Placement();
                from.readAngles(angles);
                assertTrue("pitch " + angles.y, angles.y >= -90 && angles.y <= 90);
                to.setRotation(angles.z, angles.y, angles.x);
                assertIsNear(from, to);
                from.readQuaternion(numbers);
                assertTrue("w " + numbers[3], numbers[3] >= 0);
                to = new Placement();
                to.setQuaternion(numbers[0], numbers[1], numbers[2], numbers[3]);
                assertIsNear(from, to);
                numbers[3] = 0;
                from.readMatrix(numbers);
                to = new Placement();
                assertTrue(to.setMatrix(numbers));
                assertIsNear(from, to);
                assertTrue(Math.abs(to.size / from.size - 1) < ROUNDING && to.x == from.x && to.y == from.y && to.z == from.z);
                from.readRows(numbers, 2);
                to.setRows(numbers, 2);
                assertTrue(to.hasRotationOf(from));
                numbers = new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
            }
        }

        [Test]
        public function aMatrixPlacesAsItsPlacement():void
        {
            var numbers:Vector.<Number> = new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
            var placement:Placement = new Placement();
            for each (var turn:Number in [90, 0, 30, 0, 1e-7])
            {
                var from:Placement = new Placement();
                from.setRotation(turn, 0, 0);
                from.readMatrix(numbers);
                placement.setMatrix(numbers);
                var ball:Sphere = new Sphere(new Vector3D(1, 0, 0), 0.5);
                assertTrue("turned by " + turn, Vector3D.distance(Sphere(ball.place(from)).center, Sphere(ball.place(placement)).center) < ROUNDING);
            }
        }

        [Test]
        public function aSmallNumberBesideADiagonalOfOnesCounts():void
        {
            var numbers:Vector.<Number> = new Vector.<Number>(9, true);
            var placement:Placement = new Placement();
            placement.readRows(numbers, 0);
            placement.setRows(numbers, 0);
            for each (var at:int in [1, 2, 3, 5, 6, 7])
            {
                numbers[at] = 1e-9;
                placement.setRows(numbers, 0);
                var far:Vector3D = new Vector3D(1e6, 1e6, 1e6);
                placement.place(far, far);
                assertTrue("number " + at, Math.abs([far.x, far.y, far.z][int(at / 3)] - 1e6 - 1e-3) < 1e-6);
                numbers[at] = 0;
            }
        }

        [Test]
        public function aMatrixThatDoesMoreIsRefused():void
        {
            var from:Placement = randomPlacement(1e-9);
            for (var i:int = 0; i < 16; i++)
            {
                var numbers:Vector.<Number> = new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
                from.readMatrix(numbers);
                numbers[i] += 0.1 * from.size;
                assertEquals("number " + i, i >= 12 && i < 15, new Placement().setMatrix(numbers));
            }
            from.readMatrix(numbers);
            numbers[15] = 1;
            for each (i in [8, 9, 10])
            {
                numbers[i] = -numbers[i];
            }
            assertFalse("a reflection", new Placement().setMatrix(numbers));
        }

        [Test]
        public function aQuaternionMayHaveAnyLength():void
        {
            var placement:Placement = new Placement();
            var expected:Placement = new Placement();
            expected.setQuaternion(0.5, 0.5, -0.5, 0.5);
            for each (var length:Number in [1e-149, 1e-3, 2, 1e149])
            {
                placement.setQuaternion(length, length, -length, length);
                assertTrue("a rotation", placement.isRotation);
                assertIsNear(expected, placement);
            }
            for each (length in [1e-151, 1e-160, 1e-170, 0])
            {
                placement.setQuaternion(0, 0, length, length);
                assertTrue("none of " + length, placement.hasRotationOf(Placement.IDENTITY));
            }
        }

        [Test]
        public function placesPointsAlike():void
        {
            for (var i:int = 0; i < 50; i++)
            {
                var placement:Placement = randomPlacement(1e-9);
                var point:Vector3D = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1));
                var matrix:Vector.<Number> = new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
                placement.readMatrix(matrix);
                var moved:Vector.<Number> = placePoints(placement, new <Number>[9, 9, 9, point.x, point.y, point.z], 3, 6, new Vector.<Number>());
                var expected:Array = [0, 1, 2].map(function(row:int, ...rest):Number
                    {
                        return matrix[row] * point.x + matrix[4 + row] * point.y + matrix[8 + row] * point.z + matrix[12 + row];
                    });
                placement.place(point, point);
                assertEquals(3, moved.length);
                for (var k:int = 0; k < 3; k++)
                {
                    assertTrue(Math.abs(moved[k] - expected[k]) < 1e-9);
                    assertTrue(Math.abs([point.x, point.y, point.z][k] - expected[k]) < 1e-9);
                }
            }
        }

        [Test]
        public function theInverseBringsPointsBack():void
        {
            var inverse:Placement = new Placement();
            for (var i:int = 0; i < 500; i++)
            {
                var placement:Placement = i == 0 ? new Placement() : randomPlacement(i % 5 == 0 ? 90 : 1e-9);
                var point:Vector3D = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1));
                var there:Vector3D = new Vector3D();
                Placement.invert(placement, inverse);
                placement.place(point, there);
                inverse.place(there, there);
                var error:Number = Vector3D.distance(point, there);
                assertTrue(i + ": " + error, error <= ROUNDING * (1 + Math.abs(inverse.x) + Math.abs(inverse.y) + Math.abs(inverse.z)));
            }
        }

        // With angles that are multiples of a step, or nearly random.
        private function randomPlacement(step:Number):Placement
        {
            var placement:Placement = new Placement();
            placement.x = _random.between(-50, 50);
            placement.y = _random.between(-50, 50);
            placement.z = _random.between(-50, 50);
            placement.size = _random.logBetween(0.1, 10);
            placement.setRotation(angle(step), angle(step), angle(step));
            return placement;
        }

        private function angle(step:Number):Number
        {
            return step * Math.round(_random.between(-720, 720) / step);
        }

        private static function assertIsNear(expected:Placement, actual:Placement):void
        {
            var a:Vector.<Number> = new Vector.<Number>(9);
            var b:Vector.<Number> = new Vector.<Number>(9);
            expected.readRows(a, 0);
            actual.readRows(b, 0);
            for (var i:int = 0; i < 9; i++)
            {
                assertTrue(a.join(" ") + " is not " + b.join(" "), Math.abs(a[i] - b[i]) < ROUNDING);
            }
        }
    }
}
