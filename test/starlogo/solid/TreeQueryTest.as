package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.intersects;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.Fixtures;

    use namespace engine;

    /** Depths of all combinations find no more the deeper they are; nothing overflows, whatever the sizes. */
    public class TreeQueryTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static var sHierarchies:Object = {};

        private var _trees:TreeTreeQuery = new TreeTreeQuery(new TreeCounts());
        private var _treeAndStructure:TreeStructureQuery = new TreeStructureQuery(new TreeCounts());

        [Test]
        public function specksBesideGiants():void
        {
            var random:SeededRandom = new SeededRandom(171);
            for each (var size:Number in [1e-6, 1e-9, 1e-12])
            {
                for each (var giant:Number in [1, 1e3, 1e6])
                {
                    checkSpeck(random, size, giant, hierarchyOf(BuiltInModel.cube()), hierarchyOf(BuiltInModel.sphere()));
                }
            }
        }

        /** Two cubes' faces touch across the whole gap of Touching. No quick test is stricter. */
        [Test]
        public function trianglesTouchAcrossTheWholeGap():void
        {
            var cube:ModelTree = hierarchyOf(BuiltInModel.cube());
            var half:Number = Math.abs(cube.boxTree.vertices[0]);
            var stands:Placement = new Placement();
            var beside:Placement = new Placement();
            var triangle:ConvexShape = new ConvexShape();
            var corners:Vector.<Number> = new Vector.<Number>(9);
            cube.treeFor(BoxTree.EXACT).readTriangle(0, corners);
            triangle.setTriangle(corners, 0);
            var tested:int = 0;
            for (var step:int = 0; step < 800; step++)
            {
                var gap:Number = step * Math.pow(2, -53);
                beside.x = 2 * half + gap;
                var between:Number = beside.x - 2 * half;
                var margin:Number = Touching.marginOfPlace(beside.x, 0, 0) + Touching.marginOfSurface(2 * cube.boxTree.boundingRadius);
                var reach:Number = margin + Tolerances.CORES * 2 * triangle.boundingRadius;
                if (between > 0.99 * margin && between < 0.99 * reach)
                {
                    tested++;
                    assertTrue("standing " + between, _trees.setTo(cube, stands, BoxTree.EXACT, cube, beside, BoxTree.EXACT).areTouching());
                }
            }
            assertTrue("tested " + tested, tested > 3);
        }

        /** The pair remembers the last triangle that it found, which a smaller model does not have. */
        [Test]
        public function theCommonPointIsNotOfATriangleOfThePairBefore():void
        {
            var bear:ModelTree = hierarchyOf(new ObjModel("bear", Fixtures.text(FIXTURES[0])));
            var cube:ModelTree = hierarchyOf(BuiltInModel.cube());
            var stands:Placement = new Placement();
            var pair:TreeStructureQuery = _treeAndStructure;
            var out:ClosestPoints = new ClosestPoints();
            var corners:Vector.<Number> = new Vector.<Number>(9);
            for (var index:int = bear.boxTree.primitiveCount - 1; index > cube.boxTree.primitiveCount; index -= 100)
            {
                bear.treeFor(BoxTree.EXACT).readTriangle(index, corners);
                var sphere:Sphere = new Sphere(new Vector3D(corners[0], corners[1], corners[2]), 1e-6);
                pair.setTo(bear, stands, BoxTree.EXACT, sphere, stands);
                assertTrue(pair.areTouching());
                pair.findInside(out);
                out.a.x = 7;
                pair.setTo(cube, stands, BoxTree.EXACT, new Sphere(new Vector3D(5, 5, 5), 0.1), stands);
                assertFalse(pair.areTouching());
                pair.findInside(out);
                assertEquals(7, out.a.x);
            }
            // nor is it where the pair before stood
            var moved:Placement = new Placement();
            moved.x = 5;
            pair.setTo(cube, stands, BoxTree.EXACT, new Sphere(new Vector3D(-5, 0, 0.5), 0.1), moved);
            assertTrue(pair.areTouching());
            assertTrue(pair.findInside(out));
            assertEquals(0, out.a.x);
        }

        /** The traversals find what a loop over all pairs of leaves finds. */
        [Test]
        public function boxesFindWhatStructuresDo():void
        {
            var random:SeededRandom = new SeededRandom(2117);
            var trees:TreePair = new TreePair();
            var pose:RelativePose = trees.pose = new RelativePose();
            var boxes:OverlapTraversal = new OverlapTraversal(new TreeCounts());
            var bear:ModelTree = hierarchyOf(new ObjModel("bear", Fixtures.text(FIXTURES[0])));
            var ball:ModelTree = hierarchyOf(BuiltInModel.sphere());
            var count:int = Effort.choose(300, 30000);
            var hits:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var a:ModelTree = random.pick([bear, ball]);
                var b:ModelTree = random.pick([bear, ball]);
                pose.setBetween(randomPlacement(random), randomPlacement(random), RelativeMotion.NONE, 0);
                trees.a = a.boxTree;
                trees.b = b.boxTree;
                trees.depthA = random.integer(1, 6);
                trees.depthB = random.integer(1, 6);
                var answer:Boolean = someOverlap(pose, deciding(a.root, trees.depthA, []), deciding(b.root, trees.depthB, []));
                assertEquals("pair " + i, answer, boxes.find(trees, null) == OverlapTraversal.OVERLAPPING);
                hits += answer ? 1 : 0;
            }
            assertTrue(hits + " of " + count, hits > count / 4 && hits < count * 3 / 4);
        }

        /** A model whose box does not meet another one's is not inside of it. So its inside is not computed, which is slow. */
        [Test]
        public function boxesThatAreApartPrepareNoInside():void
        {
            var a:ModelTree = newTetrahedron();
            var b:ModelTree = newTetrahedron();
            var stands:Placement = new Placement();
            assertTrue("one node each", a.root.isLeaf && b.root.isLeaf);
            assertFalse("apart", treesOverlap(a, stands, BoxTree.EXACT, b, placed(0.5, 2, 0, 0), BoxTree.EXACT));
            assertFalse("no inside", a.isExactPrepared || b.isExactPrepared);
            assertTrue("one in the other", treesOverlap(a, stands, BoxTree.EXACT, b, placed(0.1, 0, 0, 0.1), BoxTree.EXACT));
            assertTrue("the other way round", treesOverlap(b, placed(0.1, 0, 0, 0.1), BoxTree.EXACT, a, stands, BoxTree.EXACT));
            assertFalse("in a corner of the box", treesOverlap(a, stands, BoxTree.EXACT, b, placed(0.1, 0.3, 0.3, 0.8), BoxTree.EXACT));
        }

        private static function newTetrahedron():ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add("tetrahedron", new <Number>[-0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0, 0, 0, 1], new <uint>[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
            return library.treeOf("tetrahedron");
        }

        private static function deciding(node:HierarchyNode, depth:int, out:Array):Array
        {
            if (node.isLeaf || depth == 1)
            {
                out.push(node.bounds);
                return out;
            }
            return deciding(node.right, depth - 1, deciding(node.left, depth - 1, out));
        }

        private static function someOverlap(pose:RelativePose, a:Array, b:Array):Boolean
        {
            for each (var second:BoundingStructure in b)
            {
                second = second.place(pose.placement);
                for each (var first:BoundingStructure in a)
                {
                    if (intersects(first, second))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private static function randomPlacement(random:SeededRandom):Placement
        {
            var placement:Placement = placed(random.logBetween(0.5, 2), random.between(-0.8, 0.8), random.between(-0.8, 0.8), random.between(-0.8, 0.8));
            var isUpright:Boolean = random.chance(0.4);
            placement.setRotation(random.between(0, 360), isUpright ? 0 : random.between(0, 360), isUpright ? 0 : random.between(0, 360));
            return placement;
        }

        [Test]
        public function depthsBelongToTheirModelsInAnyOrder():void
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.minVerticesToSplit = 1;
            // two walls far apart, and nothing between them
            library.add("walls", new <Number>[-0.5, -0.5, 0, -0.5, 0.5, 0, -0.5, 0, 1, 0.5, -0.5, 0, 0.5, 0.5, 0, 0.5, 0, 1], new <uint>[0, 1, 2, 3, 4, 5]);
            var walls:ModelTree = library.treeOf("walls");
            var speck:ModelTree = hierarchyOf(BuiltInModel.sphere());
            var large:Placement = placed(1e6, 0, 0, 0);
            var small:Placement = placed(1e-6, 0, 0, 0.5e6);
            assertTrue("one box", treesOverlap(walls, large, 1, speck, small, 9));
            assertTrue("one box, the other way round", treesOverlap(speck, small, 9, walls, large, 1));
            assertFalse("two boxes", treesOverlap(walls, large, 9, speck, small, 1));
            assertFalse("two boxes, the other way round", treesOverlap(speck, small, 1, walls, large, 9));
        }

        private function checkSpeck(random:SeededRandom, size:Number, giant:Number, cube:ModelTree, ball:ModelTree):void
        {
            // a corner of the cube, a point of a face, well inside; beside it, far off: x, y, z, whether it collides, and is near
            var places:Array = [[0.5, 0.5, 1, true, true], [0.5, 0.1, 0.3, true, true], [0.1, 0.2, 0.3, true, true],
                    [0.50001, 0.1, 0.3, false, true], [5, 4, 3, false, false]];
            for each (var place:Array in places)
            {
                var heading:Number = random.pick([0, 90, 180]);
                var large:Placement = placed(giant, 0, 0, 0);
                large.setRotation(0, 0, 0);
                var small:Placement = placed(size * giant, place[0] * giant, place[1] * giant, place[2] * giant);
                small.setRotation(heading, random.pick([0, 90]), 0);
                var message:String = [size, giant, place, heading].join(", ");
                for each (var depth:int in [1, 3, 10])
                {
                    assertEquals(message, place[3], treesOverlap(cube, large, depth, ball, small, depth));
                    assertEquals(message, place[3], treesOverlap(ball, small, depth, cube, large, depth));
                    for each (var box:BoundingStructure in structures(0.5))
                    {
                        assertEquals(message + box, place[3], structureOverlaps(cube, large, depth, box, small));
                    }
                    // a cube's sphere and capsule reach farther
                    if (place[3])
                    {
                        for each (box in structures(1))
                        {
                            assertTrue(message + box, structureOverlaps(ball, small, depth, box, large));
                        }
                    }
                    else
                    {
                        assertFalse(message, structureOverlaps(ball, small, depth, structures(0.5)[2], large));
                    }
                }
                assertEquals(message, place[3], treesOverlap(cube, large, BoxTree.EXACT, ball, small, BoxTree.EXACT));
                assertEquals(message, place[3], treesOverlap(ball, small, BoxTree.EXACT, cube, large, BoxTree.EXACT));
            }
        }

        private function treesOverlap(a:ModelTree, placementA:Placement, depthA:int, b:ModelTree, placementB:Placement, depthB:int):Boolean
        {
            return _trees.setTo(a, placementA, depthA, b, placementB, depthB).areTouching();
        }

        private function structureOverlaps(a:ModelTree, placementA:Placement, depth:int, structure:BoundingStructure, placementB:Placement):Boolean
        {
            return _treeAndStructure.setTo(a, placementA, depth, structure, placementB).areTouching();
        }

        // About the middle of a model of size 1.
        private static function structures(half:Number):Array
        {
            var middle:Vector3D = new Vector3D(0, 0, 0.5);
            return [new Sphere(middle, half), new Capsule(new Vector3D(0, 0, 0.3), new Vector3D(0, 0, 0.7), half),
                    new Box(middle, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, half, half, half)];
        }

        private static function placed(size:Number, x:Number, y:Number, z:Number):Placement
        {
            var placement:Placement = new Placement();
            placement.size = size;
            placement.x = x;
            placement.y = y;
            placement.z = z;
            return placement;
        }

        private static function hierarchyOf(model:Model):ModelTree
        {
            sHierarchies[model.name] ||= built(model);
            return sHierarchies[model.name];
        }

        private static function built(model:Model):ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add(model.name, model.vertices, model.triangles);
            return library.treeOf(model.name);
        }
    }
}
