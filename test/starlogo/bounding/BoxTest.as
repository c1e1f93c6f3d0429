package starlogo.bounding
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import support.Structures;

    use namespace engine;

    public class BoxTest
    {
        private static const X:Vector3D = new Vector3D(1, 0, 0);
        private static const Y:Vector3D = new Vector3D(0, 1, 0);
        private static const Z:Vector3D = new Vector3D(0, 0, 1);

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
        public function aCopyHasTheSameNumbers():void
        {
            var random:SeededRandom = new SeededRandom(7301);
            var structures:RandomStructures = new RandomStructures(random);
            for (var i:int = 0; i < 200; i++)
            {
                var axes:Vector.<Vector3D> = structures.frame();
                var box:Box = new Box(structures.position(1), axes[0], axes[1], axes[2], 1, 2, 3);
                assertEquals(box.toNumbers().join(), Box(box.clone()).toNumbers().join());
            }
        }

        private static function assertExact(what:String, expected:Number, actual:Number):void
        {
            assertTrue(what + ": " + actual, Math.abs(actual - expected) < 1e-15);
        }
    }
}
