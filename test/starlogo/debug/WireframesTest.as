package starlogo.debug
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.Structures;
    import support.SurfaceDistance;
    import support.assertThrows;

    public class WireframesTest
    {
        [Test]
        public function endsAreOnTheSurface():void
        {
            for each (var structure:BoundingStructure in Structures.samples())
            {
                var lines:Vector.<Number> = Wireframes.ofStructure(structure);
                assertTrue(lines.length > 0 && lines.length % 6 == 0);
                for (var i:int = 0; i < lines.length; i += 3)
                {
                    var distance:Number = SurfaceDistance.of(structure, new Vector3D(lines[i], lines[i + 1], lines[i + 2]));
                    assertTrue(structure + ": an end is " + distance + " off", distance < 1e-12);
                }
            }
        }

        [Test]
        public function linesReachAsFarAsTheStructure():void
        {
            for each (var structure:BoundingStructure in Structures.samples())
            {
                var lines:Vector.<Number> = Wireframes.ofStructure(structure);
                var extents:Vector.<Number> = new Vector.<Number>(6);
                structure.extentsInto(extents);
                for (var axis:int = 0; axis < 3; axis++)
                {
                    var low:Number = Infinity;
                    var high:Number = -Infinity;
                    for (var i:int = axis; i < lines.length; i += 3)
                    {
                        low = Math.min(low, lines[i]);
                        high = Math.max(high, lines[i]);
                    }
                    var gap:Number = (extents[2 * axis + 1] - extents[2 * axis] - (high - low)) / (extents[2 * axis + 1] - extents[2 * axis]);
                    assertTrue("of the extent, " + gap + " is not drawn", gap > -1e-12 && gap < 0.1);
                }
            }
        }

        [Test]
        public function trianglesAreTheirEdgesOnce():void
        {
            // two that share an edge, whichever way they go round; one that goes nowhere; what is there already
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
            assertEquals(5 * 6, Wireframes.ofTriangles(vertices, new <uint>[0, 1, 2, 1, 0, 3]).length);
            assertEquals(5 * 6, Wireframes.ofTriangles(vertices, new <uint>[0, 1, 2, 0, 1, 3]).length);
            assertThrows(ArgumentError, /vertices must/, Wireframes.ofTriangles, null, new <uint>[0, 1, 2]);
            assertThrows(ArgumentError, /triangles must/, Wireframes.ofTriangles, vertices, null);
            assertThrows(RangeError, /there is no vertex 4$/, Wireframes.ofTriangles, vertices, new <uint>[0, 1, 4]);
            assertEquals("0,0,0,1,0,0", Wireframes.ofTriangles(vertices, new <uint>[0, 1, 0]).join());
            assertEquals("9,0,0,0,0,1,0,0", Wireframes.ofTriangles(vertices, new <uint>[1, 0, 0], new <Number>[9, 0, 0, 0, 0]).slice(0, 8).join());
        }

        [Test]
        public function whatHasNoLengthIsLeftOut():void
        {
            var here:Vector3D = new Vector3D(1, 2, 3);
            var there:Vector3D = new Vector3D(1, 2, 5);
            assertEquals(0, Wireframes.ofStructure(new Sphere(here, 0)).length);
            assertEquals(0, Wireframes.ofStructure(new Capsule(here, here, 0)).length);
            assertEquals(0, Wireframes.ofStructure(new Cylinder(here, here, 2)).length);
            assertEquals("1,2,3,1,2,5", Wireframes.ofStructure(new Capsule(here, there, 0)).join());
            assertEquals("1,2,3,1,2,5", Wireframes.ofStructure(new Cylinder(here, there, 0)).join());
            assertEquals(0, Wireframes.ofStructure(new Box(here, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0)).length);
            assertEquals("a capsule without a segment is a sphere", 2 * 32 + 4 * 16, Wireframes.ofStructure(new Capsule(here, here, 1)).length / 6);
        }

        [Test]
        public function thinAndFarStructuresHaveNumbers():void
        {
            for each (var length:Number in [1e-70, 1e-5, 1e70])
            {
                for each (var number:Number in Wireframes.ofStructure(new Capsule(new Vector3D(0, 0, 0), new Vector3D(length, -length, length), length)))
                {
                    assertTrue(isFinite(number));
                }
            }
        }

        [Test]
        public function aLevelIsItsNodesAndTheLeavesAbove():void
        {
            var hierarchies:HierarchiesLibrary = new HierarchiesLibrary();
            var model:Model = BuiltInModel.cylinder();
            hierarchies.add("cylinder", model.vertices, model.triangles);
            var leaves:int = 0;
            for (var level:int = 1; level <= 11; level++)
            {
                var nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
                leaves += collect(hierarchies.root("cylinder"), level, nodes);
                var expected:Vector.<Number> = new Vector.<Number>();
                for each (var node:HierarchyNode in nodes)
                {
                    Wireframes.ofStructure(node.bounds, expected);
                }
                assertEquals(expected.join(), Wireframes.ofLevel(hierarchies.root("cylinder"), level).join());
            }
            assertTrue("some leaves are above a level: " + leaves, leaves > 0);
        }

        // From left to right; returns how many are leaves above the level.
        private static function collect(node:HierarchyNode, level:int, out:Vector.<HierarchyNode>):int
        {
            if (level == 1 || node.isLeaf)
            {
                out.push(node);
                return level == 1 ? 0 : 1;
            }
            return collect(node.left, level - 1, out) + collect(node.right, level - 1, out);
        }

        [Test]
        public function linesAreAdded():void
        {
            var lines:Vector.<Number> = new <Number>[1, 2, 3, 4, 5, 6];
            assertStrictlyEquals(lines, Wireframes.ofStructure(new Sphere(new Vector3D(), 1), lines));
            assertEquals(6 + 3 * 32 * 6, lines.length);
            assertEquals(1, lines[0]);
        }

        [Test]
        public function nothingIsAnError():void
        {
            assertThrows(ArgumentError, /structure .*must/, Wireframes.ofStructure, null);
            assertThrows(ArgumentError, /hierarchy to draw|root must/, Wireframes.ofLevel, null, 1);
            var hierarchies:HierarchiesLibrary = new HierarchiesLibrary();
            hierarchies.add("point", new <Number>[0, 0, 0]);
            assertThrows(RangeError, /must be 1 \(the root\) or more, not 0/, Wireframes.ofLevel, hierarchies.root("point"), 0);
        }
    }
}
