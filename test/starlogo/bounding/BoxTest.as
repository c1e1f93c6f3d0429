package starlogo.bounding
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import support.Structures;

    public class BoxTest
    {
        private static const X:Vector3D = new Vector3D(1, 0, 0);
        private static const Y:Vector3D = new Vector3D(0, 1, 0);
        private static const Z:Vector3D = new Vector3D(0, 0, 1);

        [Test]
        public function volumeIsThatOfTheWholeExtents():void
        {
            assertEquals(48, new Box(new Vector3D(9, 9, 9), X, Y, Z, 1, 2, 3).volume);
            assertEquals(0, new Box(new Vector3D(), X, Y, Z, 1, 2, 0).volume);
        }

        [Test]
        public function scalesAboutTheOrigin():void
        {
            var box:Box = new Box(new Vector3D(1, 2, 3), X, Y, Z, 1, 2, 3);
            box.scale(2);
            assertTrue(box.center.equals(new Vector3D(2, 4, 6)));
            assertTrue(box.axisY.equals(Y));
            assertEquals("2,4,6", [box.halfX, box.halfY, box.halfZ]);
        }

        [Test]
        public function rotatesAboutTheOrigin():void
        {
            var box:Box = new Box(new Vector3D(1, 0, 0), X, Y, Z, 1, 2, 3);
            var quarter:Matrix3D = new Matrix3D();
            quarter.appendRotation(90, Vector3D.Z_AXIS);
            box.rotate(quarter);
            assertTrue(box.center.nearEquals(Y, 1e-6));
            assertTrue(box.axisX.nearEquals(Y, 1e-6));
            assertTrue(box.axisY.nearEquals(new Vector3D(-1, 0, 0), 1e-6));
            assertTrue(box.axisZ.nearEquals(Z, 1e-6));
        }

        [Test]
        public function containsItsCornersAndNothingBeyondItsFaces():void
        {
            var box:Box = new Box(new Vector3D(1, 0, 0), new Vector3D(0.6, 0.8, 0), new Vector3D(-0.8, 0.6, 0), Z,
                    1, 2, 3);
            assertTrue(box.contains(new Vector3D(1 + 0.6 - 1.6, 0.8 + 1.2, 3)));
            assertFalse(box.contains(new Vector3D(1 + 0.61 - 1.61, 0.81 + 1.21, 3)));
            assertFalse(box.contains(new Vector3D(1, 0, 3.0001)));
            assertFalse(box.contains(new Vector3D(1.61, 0.81, 0)));
        }

        [Test]
        public function aFlatBoxContainsItsRectangle():void
        {
            var flat:Box = new Box(new Vector3D(0, 0, 2), X, Y, Z, 1, 1, 0);
            assertTrue(flat.contains(new Vector3D(1, -1, 2)));
            assertFalse(flat.contains(new Vector3D(0, 0, 2.0001)));
        }

        [Test]
        public function copiesItsVectors():void
        {
            var center:Vector3D = new Vector3D(1, 2, 3);
            var axis:Vector3D = X.clone();
            var box:Box = new Box(center, axis, Y, Z, 1, 2, 3);
            center.x = axis.x = 7;
            assertEquals(1, box.center.x);
            assertEquals(1, box.axisX.x);
        }

        [Test]
        public function takesAxesOfEitherHandedness():void
        {
            assertEquals(8, new Box(new Vector3D(), Y, X, Z, 1, 1, 1).volume);
        }

        [Test]
        public function axesStayExactThroughManySinglePrecisionRotations():void
        {
            var box:Box = new Box(new Vector3D(), X, Y, Z, 1, 1, 1);
            var rotation:Matrix3D = new Matrix3D();
            rotation.appendRotation(33, new Vector3D(0.48, 0.6, 0.64));
            rotation = Structures.inSinglePrecision(rotation);
            for (var i:int = 0; i < 500; i++)
            {
                box.rotate(rotation);
            }
            assertExact("length of x", 1, box.axisX.dotProduct(box.axisX));
            assertExact("length of y", 1, box.axisY.dotProduct(box.axisY));
            assertExact("length of z", 1, box.axisZ.dotProduct(box.axisZ));
            assertExact("x and y", 0, box.axisX.dotProduct(box.axisY));
            assertExact("x and z", 0, box.axisX.dotProduct(box.axisZ));
            assertExact("y and z", 0, box.axisY.dotProduct(box.axisZ));
        }

        [Test]
        public function refusesHalfExtentsThatAreNone():void
        {
            for each (var half:Number in [-1, NaN, Infinity])
            {
                for each (var halves:Array in [[half, 1, 1], [1, half, 1], [1, 1, half]])
                {
                    try
                    {
                        new Box(new Vector3D(), X, Y, Z, halves[0], halves[1], halves[2]);
                    }
                    catch (error:RangeError)
                    {
                        assertTrue(error.message, error.message.indexOf(String(half)) >= 0);
                        continue;
                    }
                    fail("no error for the half-extents " + halves);
                }
            }
        }

        [Test]
        public function refusesAxesThatAreNone():void
        {
            var wrong:Array = [
                    [null, Y, Z], [X, null, Z], [X, Y, null], [X, X, Z], [new Vector3D(2, 0, 0), Y, Z],
                    [X, new Vector3D(0.01, 1, 0), Z], [X, Y, new Vector3D()]];
            for each (var axes:Array in wrong)
            {
                try
                {
                    new Box(new Vector3D(), axes[0], axes[1], axes[2], 1, 1, 1);
                }
                catch (error:ArgumentError)
                {
                    continue;
                }
                fail("no error for the axes " + axes);
            }
        }

        [Test(expects="ArgumentError")]
        public function refusesNoCenter():void
        {
            new Box(null, X, Y, Z, 1, 1, 1);
        }

        [Test(expects="RangeError")]
        public function refusesAnAxisThatIsNotANumber():void
        {
            new Box(new Vector3D(), new Vector3D(NaN, 0, 0), Y, Z, 1, 1, 1);
        }

        private static function assertExact(what:String, expected:Number, actual:Number):void
        {
            assertTrue(what + ": " + actual, Math.abs(actual - expected) < 1e-15);
        }
    }
}
