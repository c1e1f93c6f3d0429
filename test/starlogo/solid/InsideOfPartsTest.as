package starlogo.solid
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.SolidModels;

    use namespace engine;

    /** What is inside of models of several pieces: they overlap, share edges, bound cavities, and are turned in and out. test/fuzz has random ones. */
    public class InsideOfPartsTest
    {
        [Test]
        public function aPartThatIsInsideOutMakesNoHole():void
        {
            var model:Model = SolidModels.of("overlap", [[1, 0, 0, 0, false], [1, 0.5, 0.5, 0.5, true]], Model.AS_GIVEN);
            for each (var at:Array in [[0.25, 0.25, 0.75], [-0.25, -0.25, 0.25], [0.75, 0.75, 1.25]])
            {
                assertTrue(at.join(), isInside(model.vertices, model.triangles, at));
            }
            assertFalse(isInside(model.vertices, model.triangles, [-0.25, 0.75, 0.5]));
        }

        [Test]
        public function cavitiesStayHollowHoweverTheWholeIsTurned():void
        {
            // a shell, a ball of stone in its cavity with a cavity of its own, and in that a box
            for each (var isTurned:Boolean in [false, true])
            {
                var model:Model = SolidModels.of("doll", [[1, 0, 0, 0, isTurned], [0.8, 0, 0, 0.1, !isTurned], [0.6, 0, 0, 0.2, isTurned],
                            [0.4, 0, 0, 0.3, !isTurned], [0.2, 0, 0, 0.4, !isTurned]], Model.AS_GIVEN);
                for (var i:int = 0; i < 5; i++)
                {
                    assertEquals("level " + i, i != 1 && i != 3, isInside(model.vertices, model.triangles, [0.45 - 0.1 * i, 0.01, 0.51]));
                }
            }
            // cavities that overlap
            model = SolidModels.of("caves", [[1, 0, 0, 0, false], [0.5, 0, 0, 0.1, true], [0.5, 0.1, 0.1, 0.2, true]], Model.AS_GIVEN);
            assertFalse(isInside(model.vertices, model.triangles, [0.05, 0.05, 0.4]));
            assertTrue(isInside(model.vertices, model.triangles, [0.45, 0.05, 0.4]));
            // a cavity that touches the shell from within
            model = SolidModels.of("flush", [[1, 0, 0, 0, false], [0.5, 0.25, 0, 0.25, true]], Model.AS_GIVEN);
            assertFalse(isInside(model.vertices, model.triangles, [0.2, 0.05, 0.5]));
            assertTrue(isInside(model.vertices, model.triangles, [-0.2, 0.05, 0.5]));
        }

        [Test]
        public function aSheetBesideOrAtAClosedPartOpensItNot():void
        {
            var cube:Model = BuiltInModel.cube();
            for each (var isFirst:Boolean in [false, true])
            {
                var vertices:Vector.<Number> = cube.vertices.slice();
                vertices.fixed = false;
                vertices.push(2, 2, 0, 3, 2, 0, 3, 3, 1);
                // one beside it, one at an edge, and a triangle twice
                var sheets:Array = [24, 25, 26, cube.triangles[0], cube.triangles[1], 25, cube.triangles[0], cube.triangles[1], cube.triangles[2]];
                var triangles:Vector.<uint> = new Vector.<uint>();
                for each (var list:Object in isFirst ? [sheets, cube.triangles] : [cube.triangles, sheets])
                {
                    for each (var corner:uint in list)
                    {
                        triangles.push(corner);
                    }
                }
                assertTrue(isInside(vertices, triangles, [0.1, 0.2, 0.3]));
                assertFalse(isInside(vertices, triangles, [0.6, 0.2, 0.3]));
            }
        }

        [Test]
        public function aModelFarFromItsOriginHasAnInside():void
        {
            for each (var far:Number in [4e6, 1e9])
            {
                var ball:Model = BuiltInModel.sphere();
                var vertices:Vector.<Number> = new Vector.<Number>();
                for (var i:int = 0; i < ball.vertices.length; i++)
                {
                    vertices.push(ball.vertices[i] + (i % 3 == 0 ? far : 0));
                }
                assertTrue(isInside(vertices, ball.triangles, [far, 0, 0.5]));
                assertTrue(isInside(vertices, ball.triangles, [far + 0.4, 0, 0.5]));
                assertFalse(isInside(vertices, ball.triangles, [far + 0.4, 0.4, 0.5]));
            }
        }

        private static function isInside(vertices:Vector.<Number>, triangles:Vector.<uint>, at:Array):Boolean
        {
            return solidOf(vertices, triangles).isInside(new Vector3D(at[0], at[1], at[2]));
        }

        private static function solidOf(vertices:Vector.<Number>, triangles:Vector.<uint>):Interior
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add("model", vertices, triangles);
            return library.hierarchy("model").interior;
        }
    }
}
