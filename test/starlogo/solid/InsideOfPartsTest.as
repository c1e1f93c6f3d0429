package starlogo.solid
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.scaleAndRotatePoints;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.solid.interior.Interior;
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

        /** Half of the triangles of the inner cube face outwards and half inwards, so it counts as facing outwards. */
        [Test]
        public function aShellOfWhichHalfIsReversedBoundsNoCavity():void
        {
            var model:Model = SolidModels.of("nested", [[1, 0, 0, 0, false], [0.5, 0, 0, 0.25, true]], Model.AS_GIVEN);
            var center:Array = [0.01, 0.02, 0.5];
            assertFalse("a cavity", isInside(model.vertices, model.triangles, center));
            for (var odd:int = 0; odd < 2; odd++)
            {
                var triangles:Vector.<uint> = new Vector.<uint>().concat(model.triangles);
                for (var i:int = triangles.length / 2 + 3 * odd; i < triangles.length; i += 6)
                {
                    var corner:uint = triangles[i];
                    triangles[i] = triangles[i + 1];
                    triangles[i + 1] = corner;
                }
                assertTrue("reversed from " + odd, isInside(model.vertices, triangles, center));
            }
        }

        /** A file may have triangles twice, some of them reversed so that they are seen from both sides. */
        [Test]
        public function cavitiesStayHollowIfTrianglesAreDoubled():void
        {
            var model:Model = SolidModels.of("doll", [[1, 0, 0, 0, false], [0.8, 0, 0, 0.1, true], [0.6, 0, 0, 0.2, false]], Model.AS_GIVEN);
            var all:Vector.<uint> = new Vector.<uint>().concat(model.triangles);
            var third:int = all.length / 3;
            var backs:Vector.<uint> = all.concat().reverse();
            for each (var triangles:Vector.<uint> in [all.concat(all), all.concat(backs), all.concat(all.slice(0, third)),
                        all.slice(0, third).concat(all), all.concat(all.slice(third, 2 * third)), all.concat(all.slice(2 * third))])
            {
                for (var i:int = 0; i < 3; i++)
                {
                    assertEquals(triangles.length + ", level " + i, i != 1, isInside(model.vertices, triangles, [0.45 - 0.1 * i, 0.01, 0.51]));
                }
            }
        }

        /** Each copy may divide the cube's sides by other diagonals. */
        [Test]
        public function cavitiesInCavitiesStayHollowInEachCopy():void
        {
            var boxes:Array = [];
            for (var i:int = 0; i < 6; i++)
            {
                boxes.push([1 - 0.15 * i, 0, 0, 0.075 * i, i % 2 == 1]);
            }
            var model:Model = SolidModels.of("doll", boxes, Model.AS_GIVEN);
            var all:Vector.<uint> = new Vector.<uint>().concat(model.triangles);
            var backs:Vector.<uint> = all.concat().reverse();
            var others:Vector.<uint> = withOtherDiagonals(all);
            for each (var triangles:Vector.<uint> in [all, all.concat(all), all.concat(backs), backs.concat(all, all), all.concat(others), all.concat(all, all, backs)])
            {
                for (i = 0; i < 6; i++)
                {
                    assertEquals(triangles.length + ", level " + i, i % 2 == 0, isInside(model.vertices, triangles, [0.46 - 0.075 * i, 0.01, 0.51]));
                }
            }
        }

        // Each two triangles of a list are a quadrangle. Returns the two that meet at its other diagonal.
        private static function withOtherDiagonals(triangles:Vector.<uint>):Vector.<uint>
        {
            var out:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < triangles.length; i += 6)
            {
                var first:Vector.<uint> = triangles.slice(i, i + 3);
                var second:Vector.<uint> = triangles.slice(i + 3, i + 6);
                while (second.indexOf(first[0]) >= 0)
                {
                    first.push(first.shift());
                }
                while (first.indexOf(second[0]) >= 0)
                {
                    second.push(second.shift());
                }
                assertEquals(first[1], second[2]);
                out.push(first[0], first[1], second[0], first[0], second[0], first[2]);
            }
            return out;
        }

        /** The cavity touches the shell with a face that has a triangle without area, in the file or after a pose. */
        [Test]
        public function aTriangleWithoutAreaDecidesNothingAboutACavity():void
        {
            var model:Model = SolidModels.of("flush", [[1, 0, 0, 0, false], [0.5, 0.25, 0, 0.25, true]], Model.AS_GIVEN);
            var middle:uint = model.vertices.length / 3;
            var turn:Placement = new Placement();
            for each (var heading:Number in [0, 37])
            {
                turn.setRotation(heading, heading / 2, 0);
                for (var at:int = model.triangles.length / 2; at < model.triangles.length; at++)
                {
                    // the edge from a to b gets a vertex in its middle, and the flat triangle a, b, middle
                    var first:int = at - at % 3;
                    var a:uint = model.triangles[at];
                    var b:uint = model.triangles[first + (at + 1) % 3];
                    var c:uint = model.triangles[first + (at + 2) % 3];
                    var vertices:Vector.<Number> = model.vertices.slice();
                    vertices.fixed = false;
                    for (var axis:int = 0; axis < 3; axis++)
                    {
                        vertices.push((vertices[3 * a + axis] + vertices[3 * b + axis]) / 2);
                    }
                    vertices = turned(vertices, turn);
                    var triangles:Vector.<uint> = model.triangles.slice();
                    triangles.fixed = false;
                    triangles.splice(first, 3);
                    triangles.push(a, middle, c, middle, b, c, a, b, middle);
                    assertHollow("edge " + at + ", heading " + heading, hierarchyOf(vertices, triangles), turn);
                    for each (var share:Number in [-0.2, 0.2])
                    {
                        var hierarchy:ModelTree = hierarchyOf(vertices, triangles);
                        var straight:Vector.<Number> = vertices.slice();
                        for (axis = 0; axis < 3; axis++)
                        {
                            vertices[3 * middle + axis] += share * (vertices[3 * c + axis] - vertices[3 * middle + axis]);
                        }
                        hierarchy.refit();
                        hierarchy.preparedInterior();
                        for (axis = 3 * middle; axis < 3 * middle + 3; axis++)
                        {
                            vertices[axis] = straight[axis];
                        }
                        hierarchy.refit();
                        assertHollow("edge " + at + ", heading " + heading + ", posed from " + share, hierarchy, turn);
                    }
                }
            }
        }

        /** The needle is a closed shell of triangles without area. */
        [Test]
        public function aNeedleDecidesNothingAboutACavity():void
        {
            var model:Model = SolidModels.of("hollow", [[1, 0, 0, 0, false], [0.7, 0, 0, 0.15, true]], Model.AS_GIVEN);
            var first:uint = model.vertices.length / 3;
            var vertices:Vector.<Number> = new Vector.<Number>().concat(model.vertices, new <Number>[0.42, 0, 0.3, 0.42, 0, 0.4, 0.42, 0, 0.6, 0.42, 0, 0.7]);
            var triangles:Vector.<uint> = new Vector.<uint>().concat(model.triangles, new <uint>[first, first + 2, first + 1, first, first + 1, first + 3,
                        first + 1, first + 2, first + 3, first + 2, first, first + 3]);
            assertFalse("the cavity", isInside(vertices, triangles, [0.2, 0.05, 0.5]));
            assertTrue("the wall", isInside(vertices, triangles, [0.45, 0.05, 0.5]));
        }

        private static function assertHollow(message:String, hierarchy:ModelTree, turn:Placement):void
        {
            for each (var x:Number in [0.2, -0.2])
            {
                var point:Vector.<Number> = turned(new <Number>[x, 0.05, 0.5], turn);
                assertEquals(message, x < 0, hierarchy.preparedInterior().isInside(new Vector3D(point[0], point[1], point[2])));
            }
        }

        private static function turned(points:Vector.<Number>, turn:Placement):Vector.<Number>
        {
            var out:Vector.<Number> = new Vector.<Number>(points.length);
            scaleAndRotatePoints(turn, points, out);
            return out;
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

        /** Vertices are welded by the size of the triangles. */
        [Test]
        public function aFarVertexOfNoTriangleWeldsNoOthers():void
        {
            var cube:Model = BuiltInModel.cube();
            assertTrue(isInside(new Vector.<Number>().concat(cube.vertices, new <Number>[1e9, 0, 0]), cube.triangles, [0.2, 0.3, 0.4]));
        }

        private static function isInside(vertices:Vector.<Number>, triangles:Vector.<uint>, at:Array):Boolean
        {
            return solidOf(vertices, triangles).isInside(new Vector3D(at[0], at[1], at[2]));
        }

        private static function solidOf(vertices:Vector.<Number>, triangles:Vector.<uint>):Interior
        {
            return hierarchyOf(vertices, triangles).preparedInterior();
        }

        private static function hierarchyOf(vertices:Vector.<Number>, triangles:Vector.<uint>):ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add("model", vertices, triangles);
            return library.treeOf("model");
        }
    }
}
