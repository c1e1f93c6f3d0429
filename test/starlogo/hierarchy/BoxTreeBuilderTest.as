package starlogo.hierarchy
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.assertWellFormed;

    use namespace engine;

    /** Trees, as the library makes them. */
    public class BoxTreeBuilderTest
    {
        private var _library:HierarchiesLibrary = new HierarchiesLibrary();

        [Test]
        public function splitsHalfwayAlongTheLongestAxis():void
        {
            // along y: 0, 1, 2, 7, 8, 10
            _library.minVerticesToSplit = 2;
            _library.maxDepth = 2;
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 1, 1, 0, 0, 2, 1, 0, 7, 0, 0, 8, 0, 0, 10, 2];
            add("stick", vertices);
            var root:HierarchyNode = _library.root("stick");
            assertEquals(6, root.vertexCount);
            assertEquals("0,1,2", root.left.vertexIndices() + "");
            assertEquals("3,4,5", root.right.vertexIndices() + "");
            var box:Box = Box(root.left.bounds);
            assertNear(0.5, box.center.x, 1e-12);
            assertNear(1, box.center.y, 1e-12);
            assertNear(0.5, box.halfZ, 3e-12);
            assertTrue("the depth limit", root.left.isLeaf);
            assertNull(root.left.left);
        }

        [Test]
        public function splitsAtTheMeanOnDemand():void
        {
            _library.minVerticesToSplit = 3;
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 100, 0, 0];
            add("halfway", vertices);
            assertEquals("4", _library.root("halfway").right.vertexIndices() + "");
            _library.splitByMean = true;
            vertices[12] = 12;
            // the mean is 3.6, halfway is 6
            vertices[9] = 5;
            add("mean", vertices);
            assertEquals("3,4", _library.root("mean").right.vertexIndices() + "");
        }

        [Test]
        public function doesNotSplitWhatIsInOnePlace():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 20; i++)
            {
                vertices.push(0.1, 0.2, 0.3);
                triangles.push(i, (i + 1) % 20, (i + 2) % 20);
            }
            add("point", vertices);
            add("point of triangles", vertices, triangles);
            assertTrue(_library.root("point").isLeaf);
            assertTrue(_library.root("point of triangles").isLeaf);
        }

        [Test]
        public function leavesOutVerticesThatNoTriangleUses():void
        {
            add("tetrahedron and a stray", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 50, 50, 50], new <uint>[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
            assertEquals(4, _library.root("tetrahedron and a stray").vertexCount);
            assertNear(0.5, Box(_library.root("tetrahedron and a stray").bounds).halfX, 1e-12);
        }

        [Test]
        public function bothWindingsOfAFaceHaveTheVerticesOfOne():void
        {
            var pyramid:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1];
            var triangles:Vector.<uint> = new <uint>[0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2];
            var both:Vector.<uint> = triangles.concat(triangles.concat().reverse());
            add("both", pyramid, both);
            assertEquals(5, _library.root("both").vertexCount);
            assertTrue(_library.root("both").isLeaf);
            _library.minVerticesToSplit = 4;
            add("both", pyramid, both);
            assertFalse(_library.root("both").isLeaf);
        }

        [Test]
        public function isWellFormedForRandomSoups():void
        {
            var random:SeededRandom = new SeededRandom(51);
            for (var i:int = 0; i < 120; i++)
            {
                var vertices:Vector.<Number> = new Vector.<Number>();
                var count:int = random.logBetween(1, 150);
                var scale:Number = random.logBetween(1e-6, 1e6);
                // grids have many equal coordinates, and a flat model has none in z
                var isGrid:Boolean = random.chance();
                for (var k:int = 0; k < 3 * count; k++)
                {
                    vertices.push((isGrid ? random.integer(-2, 2) : random.normal()) * (k % 3 == 2 && i % 4 == 0 ? 0 : scale));
                }
                var triangles:Vector.<uint> = new Vector.<uint>();
                for (k = 0; k < 6 * count; k++)
                {
                    triangles.push(random.integer(0, count - 1));
                }
                triangles.length -= triangles.length % 3;
                _library.minVerticesToSplit = random.integer(1, 8);
                _library.maxDepth = random.integer(1, 14);
                _library.splitByMean = random.chance();
                add("soup", vertices);
                add("soup", vertices, triangles);
            }
        }

        private function add(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null):void
        {
            _library.add(name, vertices, triangles);
            assertWellFormed(_library, name, vertices, triangles);
        }

        private static function assertNear(expected:Number, actual:Number, tolerance:Number):void
        {
            assertTrue(actual + " is not " + expected, Math.abs(actual - expected) <= tolerance);
        }

        [Test]
        public function indicesAreInAscendingOrder():void
        {
            var sphere:Model = BuiltInModel.sphere();
            _library.add("triangles", sphere.vertices, sphere.triangles);
            _library.add("vertices", sphere.vertices);
            assertAscending(_library.root("triangles").triangleIndices(), sphere.triangles.length / 3);
            assertAscending(_library.root("vertices").vertexIndices(), sphere.vertices.length / 3);
        }

        private static function assertAscending(indices:Vector.<int>, count:int):void
        {
            assertEquals(count, indices.length);
            for (var i:int = 0; i < count; i++)
            {
                assertEquals(i, indices[i]);
            }
        }
    }
}
