package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.data.IntList;

    public class ShrunkBodyTest
    {
        [Test]
        public function aBodyIsFlatIfItsThicknessIsLessThanAThousandthOfItsLength():void
        {
            for each (var length:Number in [1e-6, 1, 60, 1e6])
            {
                assertFalse("a cube, " + length, isFlat(board(length, length)));
                assertFalse("a board, " + length, isFlat(board(length, length / 500)));
                assertTrue("a leaf, " + length, isFlat(board(length, length / 2000)));
                assertTrue("a sheet, " + length, isFlat(board(length, 0)));
            }
            assertTrue("a point", isFlat(new Sphere(new Vector3D(), 0)));
        }

        private static function isFlat(structure:BoundingStructure):Boolean
        {
            var body:MovingBody = new MovingBody(null);
            var shrunk:ShrunkBody = new ShrunkBody();
            body.setToStructure(structure);
            shrunk.begin(body, new IntList(), new Vector3D(), new Vector3D(0, 0, -1));
            return shrunk.isFlat;
        }

        private static function board(length:Number, thickness:Number):Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, length / 2, length / 2, thickness / 2);
        }
    }
}
