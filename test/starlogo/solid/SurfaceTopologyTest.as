package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.solid.interior.SurfaceTopology;

    use namespace engine;

    public class SurfaceTopologyTest
    {
        [Test]
        public function trianglesWithoutAreaDoNotMatter():void
        {
            var cube:Model = BuiltInModel.cube();
            var triangles:Vector.<uint> = cube.triangles.slice();
            triangles.fixed = false;
            triangles.push(3, 3, 5, 7, 7, 7);
            assertTrue(surfaceOf(cube.vertices, triangles).hasClosedShell);
        }

        [Test]
        public function aSingleTriangleIsOpen():void
        {
            assertFalse(surfaceOf(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2]).hasClosedShell);
            // there and back: closed around nothing
            assertTrue(surfaceOf(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2, 0, 2, 1]).hasClosedShell);
            assertFalse(surfaceOf(new <Number>[0, 0, 0], new <uint>[0, 0, 0]).hasClosedShell);
        }

        /** A triangle at the place of a face, the other way round, does not take the face from its solid, in any order of the triangles. */
        [Test]
        public function aTriangleOnAFaceLeavesTheSolidClosed():void
        {
            var corners:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
            var others:Array = [0, 1, 3, 1, 2, 3, 2, 0, 3];
            for each (var face:Array in [[0, 2, 1], [2, 1, 0], [1, 0, 2]])
            {
                for each (var sheet:Array in [[0, 1, 2], [1, 2, 0], [2, 0, 1]])
                {
                    assertEquals(SurfaceTopology.ORIENTABLE, stateOf(2, corners, face.concat(sheet, others)));
                    assertEquals(SurfaceTopology.ORIENTABLE, stateOf(2, corners, sheet.concat(face, others)));
                    assertEquals(SurfaceTopology.ORIENTABLE, stateOf(0, corners, others.concat(sheet, face)));
                }
            }
        }

        [Test]
        public function seamsThatRoundingPartedAreClosed():void
        {
            var random:SeededRandom = new SeededRandom(161);
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()])
            {
                // a few last bits of a double, and of single precision on either side
                for each (var rounding:Number in [4e-16, 1e-12, 6e-8])
                {
                    var vertices:Vector.<Number> = new Vector.<Number>();
                    var triangles:Vector.<uint> = new Vector.<uint>();
                    for (var i:int = 0; i < model.triangles.length; i++)
                    {
                        // a corner of its own for each triangle
                        for (var axis:int = 0; axis < 3; axis++)
                        {
                            vertices.push(model.vertices[3 * model.triangles[i] + axis] + rounding * random.between(-1, 1));
                        }
                        triangles.push(i);
                    }
                    var surface:SurfaceTopology = surfaceOf(vertices, triangles);
                    assertEquals(model.name + ", " + rounding, "-1", surface.shellStates.join());
                    assertEquals(1, surface.componentTriangles.length);
                    assertTrue("seam: " + surface.widestSeam, surface.widestSeam > rounding / 2 && surface.widestSeam <= 4 * rounding);
                }
            }
        }

        [Test]
        public function smallFeaturesAreNotWelded():void
        {
            // a cube of a millionth of the other beside it, and one on its own that is open by as much
            var cube:Model = BuiltInModel.cube();
            var vertices:Vector.<Number> = cube.vertices.slice();
            var triangles:Vector.<uint> = cube.triangles.slice();
            vertices.fixed = triangles.fixed = false;
            for (var i:int = 0; i < cube.vertices.length; i++)
            {
                vertices.push(i % 3 == 0 ? 0.6 + 1e-6 * cube.vertices[i] : 1e-6 * cube.vertices[i]);
            }
            for (i = 0; i < cube.triangles.length; i++)
            {
                triangles.push(24 + cube.triangles[i]);
            }
            assertEquals(2, surfaceOf(vertices, triangles).componentTriangles.length);
            assertTrue(surfaceOf(vertices, triangles).hasClosedShell);
            assertEquals(0, surfaceOf(vertices, triangles).widestSeam);
            // without a triangle of the small one
            assertEquals("-1,-3", surfaceOf(vertices, triangles.slice(0, triangles.length - 3)).shellStates.join());
        }

        [Test]
        public function aWallOfManyCornersTakesNoTime():void
        {
            // comparing each with each would take minutes
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 100; i++)
            {
                for (var k:int = 0; k < 100; k++)
                {
                    var first:uint = vertices.length / 3;
                    vertices.push(0, i, k, 0, i + 1, k, 0, i + 1, k + 1, 0, i, k + 1);
                    triangles.push(first, first + 1, first + 2, first, first + 2, first + 3);
                }
            }
            var surface:SurfaceTopology = surfaceOf(vertices, triangles);
            assertEquals(1, surface.componentTriangles.length);
            assertFalse(surface.hasClosedShell);
            // in a plane across the direction along which an earlier engine sorted vertices
            for (i = 0; i < vertices.length; i += 3)
            {
                vertices[i] = -(0.2717819 * vertices[i + 1] + 0.7972148 * vertices[i + 2]) / 0.5390711;
            }
            assertEquals(1, surfaceOf(vertices, triangles).componentTriangles.length);
            // all in one place
            for (i = 0; i < vertices.length; i++)
            {
                vertices[i] = 1;
            }
            assertEquals(1, surfaceOf(vertices, triangles).componentTriangles.length);
        }

        [Test]
        public function aOneSidedSurfaceHasNoFront():void
        {
            // the projective plane: six vertices, each pair of them an edge of two triangles
            var triangles:Vector.<uint> = new <uint>[0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1, 1, 2, 4, 2, 3, 5, 3, 4, 1, 4, 5, 2, 5, 1, 3];
            var surface:SurfaceTopology = surfaceOf(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 0, 1], triangles);
            assertTrue(surface.hasClosedShell);
            assertEquals("-2", surface.shellStates.join());
        }

        [Test]
        public function numbersThatNoSurfaceHasAreRefused():void
        {
            assertTrue(SurfaceTopology.read(bytesOf(1, 1, 0), 4) != null);
            assertTrue(SurfaceTopology.read(bytesOf(4, 4, 0.1), 4) != null);
            assertNull("more shells than triangles", SurfaceTopology.read(bytesOf(1, 5, 0), 4));
            assertNull("more components than triangles", SurfaceTopology.read(bytesOf(5, 1, 0), 4));
            assertNull("no component", SurfaceTopology.read(bytesOf(0, 1, 0), 4));
            assertNull(SurfaceTopology.read(bytesOf(1, -1, 0), 4));
            assertNull(SurfaceTopology.read(bytesOf(-1, 1, 0), 4));
            assertNull(SurfaceTopology.read(bytesOf(1, 1, -0.1), 4));
            assertNull(SurfaceTopology.read(bytesOf(1, 1, NaN), 4));
            assertNull(SurfaceTopology.read(bytesOf(1, 1, Infinity), 4));
        }

        // Bytes of a surface of four triangles, as writeTo() writes them.
        private static function bytesOf(components:int, shells:int, widestSeam:Number):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeInt(components);
            bytes.writeInt(shells);
            bytes.writeDouble(widestSeam);
            // runs: a number, and where it ends
            for each (var number:int in components == 0 ? [0, shells, 1, 4] : [0, shells, 0, components, 1, 4])
            {
                bytes.writeInt(number);
            }
            bytes.position = 0;
            return bytes;
        }

        [Test]
        public function aLargeOneIsAsASmallOne():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            addTorus(90, 60, vertices, triangles);
            var random:SeededRandom = new SeededRandom(5);
            var isTurned:Vector.<Boolean> = new Vector.<Boolean>(triangles.length / 3);
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                isTurned[i / 3] = random.next() < 0.3;
                if (isTurned[i / 3])
                {
                    swap(triangles, i);
                }
            }
            var surface:SurfaceTopology = surfaceOf(vertices, triangles);
            assertEquals("-1", surface.shellStates.join());
            assertEquals(1, surface.componentTriangles.length);
            for each (i in turnedIn(surface))
            {
                isTurned[i] = !isTurned[i];
            }
            // all are alike now
            assertEquals(-1, isTurned.indexOf(!isTurned[0]));
            assertFalse(surfaceOf(vertices, triangles.slice(0, triangles.length - 3)).hasClosedShell);
            // a wall from one vertex to the next: three triangles at its edges
            surface = surfaceOf(vertices, triangles.concat(new <uint>[0, 1, 60 * 45, 1, 0, 60 * 45]));
            assertEquals("-1,-1", surface.shellStates.join());
        }

        // Of so many columns and rows of squares, each of two triangles.
        private static function addTorus(columns:int, rows:int, vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            for (var i:int = 0; i < columns; i++)
            {
                var around:Number = 2 * Math.PI * i / columns;
                for (var k:int = 0; k < rows; k++)
                {
                    var across:Number = 2 * Math.PI * k / rows;
                    var radius:Number = 3 + Math.cos(across);
                    vertices.push(radius * Math.cos(around), radius * Math.sin(around), Math.sin(across));
                    var right:int = (i + 1) % columns * rows;
                    var above:int = (k + 1) % rows;
                    triangles.push(i * rows + k, right + k, right + above, i * rows + k, right + above, i * rows + above);
                }
            }
        }

        private static function swap(triangles:Vector.<uint>, at:int):void
        {
            var corner:uint = triangles[at];
            triangles[at] = triangles[at + 1];
            triangles[at + 1] = corner;
        }

        // The triangles that are turned, or the others, if these are fewer: of each piece.
        private static function turnedIn(surface:SurfaceTopology):Array
        {
            var turned:Array = [];
            for (var piece:int = 1; piece <= surface.shellStates.length; piece++)
            {
                var groups:Array = [[], []];
                for (var i:int = 0; i < surface.orientedShells.length; i++)
                {
                    if (Math.abs(surface.orientedShells[i]) == piece)
                    {
                        groups[surface.orientedShells[i] > 0 ? 0 : 1].push(i);
                    }
                }
                turned = turned.concat(groups[0].length < groups[1].length ? groups[0] : groups[1]);
            }
            return turned;
        }

        // The state of the shell that has a triangle.
        private static function stateOf(triangle:int, vertices:Vector.<Number>, triangles:Array):int
        {
            var surface:SurfaceTopology = surfaceOf(vertices, Vector.<uint>(triangles));
            return surface.shellStates[surface.shellOf(triangle)];
        }

        private static function surfaceOf(vertices:Vector.<Number>, triangles:Vector.<uint>):SurfaceTopology
        {
            var tree:ModelTree = new ModelTree(new BoxTree(vertices, triangles));
            tree.beginBuilding(BoxTreeBuilder.DEFAULT_LEAF_VERTICES, BoxTreeBuilder.DEFAULT_DEPTH, false, true);
            tree.finishBuilding();
            return tree.surface;
        }
    }
}
