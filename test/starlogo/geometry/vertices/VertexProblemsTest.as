package starlogo.geometry.vertices
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;

    public class VertexProblemsTest
    {
        [Test]
        public function nothingIsWrongWithWhatCanBeUsed():void
        {
            assertNull(vertexProblem(new <Number>[0, -1e308, Number.MIN_VALUE]));
            assertNull(vertexProblem(new <Number>[1, 2, 3, 4, 5, 6]));
            assertNull(triangleProblem(new Vector.<uint>(), 1));
            assertNull(triangleProblem(new <uint>[0, 1, 2, 2, 2, 2], 3));
        }

        [Test]
        public function saysWhichVertexIsWrong():void
        {
            var needed:String = "at least one vertex with three coordinates each is needed, not ";
            assertEquals(needed + "null", vertexProblem(null));
            assertEquals(needed + "0 numbers", vertexProblem(new Vector.<Number>()));
            assertEquals(needed + "7 numbers", vertexProblem(new <Number>[0, 1, 2, 3, 4, 5, 6]));
            assertEquals("the x coordinate of vertex 0 must be a finite number, not Infinity",
                    vertexProblem(new <Number>[Infinity, 1, 2]));
            assertEquals("the y coordinate of vertex 1 must be a finite number, not NaN",
                    vertexProblem(new <Number>[0, 1, 2, 3, NaN, 5]));
            assertEquals("the z coordinate of vertex 1 must be a finite number, not -Infinity",
                    vertexProblem(new <Number>[0, 1, 2, 3, 4, -Infinity]));
        }

        [Test]
        public function saysWhichTriangleIsWrong():void
        {
            assertEquals("triangles have three vertices each, but there are 7 indices in all",
                    triangleProblem(new <uint>[0, 1, 2, 0, 1, 2, 0], 3));
            assertEquals("triangle 1 names vertex 3, the last one is 2",
                    triangleProblem(new <uint>[0, 1, 2, 0, 3, 2], 3));
            assertEquals("triangle 0 names vertex 4294967295, the last one is 2",
                    triangleProblem(new <uint>[0, 1, 0xffffffff], 3));
        }
    }
}
