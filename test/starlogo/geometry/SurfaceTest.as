package starlogo.geometry
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    public class SurfaceTest
    {
        [Test]
        public function theBuiltInModelsAreClosed():void
        {
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()])
            {
                var surface:Surface = Surface.of(model.vertices, model.triangles);
                assertTrue(model.name, surface.isClosed);
                assertTrue(model.name, surface.isOriented);
                assertEquals("pieces", 1, surface.pieceCount);
            }
        }

        [Test]
        public function aMissingTriangleOpensIt():void
        {
            var cube:Model = BuiltInModel.cube();
            var surface:Surface = Surface.of(cube.vertices, cube.triangles.slice(3));
            assertFalse(surface.isClosed);
            assertEquals("pieces", 1, surface.pieceCount);
        }

        [Test]
        public function aTriangleTurnedRoundLeavesItClosed():void
        {
            var cube:Model = BuiltInModel.cube();
            var triangles:Vector.<uint> = cube.triangles.slice();
            var first:uint = triangles[0];
            triangles[0] = triangles[1];
            triangles[1] = first;
            var surface:Surface = Surface.of(cube.vertices, triangles);
            assertTrue(surface.isClosed);
            assertFalse(surface.isOriented);
        }

        [Test]
        public function trianglesWithoutAreaDoNotMatter():void
        {
            var cube:Model = BuiltInModel.cube();
            var triangles:Vector.<uint> = cube.triangles.slice();
            triangles.fixed = false;
            triangles.push(3, 3, 5, 7, 7, 7);
            assertTrue(Surface.of(cube.vertices, triangles).isClosed);
        }

        [Test]
        public function countsPieces():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var piece:int = 0; piece < 3; piece++)
            {
                // three tetrahedra in a row
                vertices.push(5 * piece, 0, 0, 5 * piece + 1, 0, 0, 5 * piece, 1, 0, 5 * piece, 0, 1);
                for each (var corner:int in [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])
                {
                    triangles.push(4 * piece + corner);
                }
            }
            var surface:Surface = Surface.of(vertices, triangles);
            assertTrue(surface.isClosed);
            assertEquals(3, surface.pieceCount);
        }

        [Test]
        public function aSingleTriangleIsOpen():void
        {
            assertFalse(Surface.of(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2]).isClosed);
            // there and back: closed around nothing
            assertTrue(Surface.of(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2, 0, 2, 1]).isClosed);
            assertFalse(Surface.of(new <Number>[0, 0, 0], new <uint>[0, 0, 0]).isClosed);
        }
    }
}
