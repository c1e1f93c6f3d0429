package starlogo.solid
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.Fixtures;
    import support.SolidModels;

    use namespace engine;

    /** The nodes below the thesis's leaves, which exact tests and rays visit, and which no client sees. */
    public class RefinedHierarchyTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/fortress.obj", "/assets/dragon.dae"];

        private static const MOST:int = 8;

        [Test]
        public function aClientSeesTheSameTree():void
        {
            for each (var model:Model in models())
            {
                var hierarchy:ModelTree = hierarchyOf(model, 6);
                var before:String = describe(hierarchy.root);
                hierarchy.preparedInterior();
                assertEquals(model.name, before, describe(hierarchy.root));
            }
        }

        [Test]
        public function leavesHaveFewTrianglesAndBoxesAroundThem():void
        {
            for each (var model:Model in models())
            {
                var hierarchy:ModelTree = hierarchyOf(model, 4);
                hierarchy.preparedInterior();
                var isListed:Vector.<Boolean> = new Vector.<Boolean>(hierarchy.boxTree.primitives.length, true);
                for each (var triangle:int in hierarchy.boxTree.primitives)
                {
                    assertTrue(!isListed[triangle]);
                    isListed[triangle] = true;
                }
                check(hierarchy.boxTree, 0);
            }
        }

        [Test]
        public function trianglesInOnePlaceAreDividedByNumber():void
        {
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0];
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 37; i++)
            {
                triangles.push(0, 1, 2);
            }
            var hierarchy:ModelTree = hierarchyOf(new Model("pile", vertices, triangles), 10);
            assertTrue(hierarchy.root.isLeaf);
            hierarchy.preparedInterior();
            assertTrue(hierarchy.root.isLeaf);
            assertNull(hierarchy.root.left);
            assertEquals(37, hierarchy.root.triangleCount);
            assertEquals(8, check(hierarchy.boxTree, 0));
        }

        // Halfway along x, each division takes the needle that begins first away from all others.
        [Test]
        public function parallelNeedlesMakeNoDeepTree():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            var count:int = 1500;
            for (var i:int = 0; i < count; i++)
            {
                vertices.push(i, 0, 0, 1e4 + (i < count - 1 ? 0 : 0.5), 0, 0, 5e3, 0.01, 0);
                triangles.push(3 * i, 3 * i + 1, 3 * i + 2);
            }
            var hierarchy:ModelTree = hierarchyOf(new Model("needles", vertices, triangles), 10);
            assertEquals("one at a time", 1, hierarchy.root.left.triangleCount);
            hierarchy.preparedInterior();
            check(hierarchy.boxTree, 0);
            var deepest:int = deepestOf(hierarchy.boxTree);
            assertTrue(deepest + " levels", deepest > 20 && deepest <= Tolerances.NESTED_LEVELS + 12);
        }

        private static function deepestOf(tree:BoxTree):int
        {
            var deepest:int = 0;
            for (var node:int = 0; node < tree.left.length; node++)
            {
                deepest = Math.max(deepest, tree.levelOf(node));
            }
            return deepest;
        }

        [Test]
        public function noDepthLimitReachesBelow():void
        {
            var bear:Model = read(FIXTURES[0]);
            var greatLand:GreatLand = new GreatLand();
            greatLand.hierarchies.maxDepth = 3;
            greatLand.addModel(bear);
            var agents:Vector.<Agent> = new <Agent>[new Agent("bear"), new Agent("bear"), new Agent("bear")];
            agents[1].moveTo(0.2, 0.4, 0.1);
            agents[2].moveTo(0.7, 0.5, 0.1);
            agents[2].traversalDepth = int.MAX_VALUE;
            var before:int = visitsOf(greatLand, agents);
            greatLand.hierarchies.treeOf("bear").preparedInterior();
            assertEquals(before, visitsOf(greatLand, agents));
        }

        // Of a collider that has seen nothing: one whose agents have not changed since visits nothing.
        private static function visitsOf(greatLand:GreatLand, agents:Vector.<Agent>):int
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.maxDepth = int.MAX_VALUE;
            collider.findCollisions(agents);
            assertTrue(collider.statistics.nodeVisits > 0);
            return collider.statistics.nodeVisits;
        }

        // How many leaves there are below a node.
        private static function check(tree:BoxTree, node:int):int
        {
            var box:Vector.<Number> = tree.boxes.slice(6 * node, 6 * node + 6);
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            var left:int = tree.left[node];
            var isLeaf:Boolean = tree.leafUpToDepth[node] >= BoxTree.LEAVES;
            assertTrue(tree.endPrimitive[node] > tree.firstPrimitive[node]);
            for (var i:int = tree.firstPrimitive[node]; i < tree.endPrimitive[node]; i++)
            {
                tree.readExtents(i, i + 1, extents, 0);
                for (var axis:int = 0; axis < 3; axis++)
                {
                    assertTrue(box[axis] - box[axis + 3] < extents[2 * axis]);
                    assertTrue(box[axis] + box[axis + 3] > extents[2 * axis + 1]);
                }
            }
            if (left == 0)
            {
                assertEquals(int.MAX_VALUE, tree.leafUpToDepth[node]);
                assertTrue("triangles: " + (tree.endPrimitive[node] - tree.firstPrimitive[node]), tree.endPrimitive[node] - tree.firstPrimitive[node] <= MOST);
                return 1;
            }
            assertEquals(tree.firstPrimitive[node], tree.firstPrimitive[left]);
            assertEquals(tree.endPrimitive[left], tree.firstPrimitive[left + 1]);
            assertEquals(tree.endPrimitive[node], tree.endPrimitive[left + 1]);
            assertEquals(tree.levelOf(node) + 1, tree.levelOf(left));
            assertEquals(isLeaf ? BoxTree.LEAVES : tree.levelOf(node), tree.leafUpToDepth[node]);
            assertTrue("below a leaf are leaves", !isLeaf || tree.leafUpToDepth[left] >= BoxTree.LEAVES && tree.leafUpToDepth[left + 1] >= BoxTree.LEAVES);
            return check(tree, left) + check(tree, left + 1);
        }

        private static function describe(node:HierarchyNode):String
        {
            var text:String = [node.bounds.volume, node.vertexCount, node.triangleIndices()].join(" ");
            return node.isLeaf ? text : text + "(" + describe(node.left) + describe(node.right) + ")";
        }

        private static function models():Array
        {
            return SolidModels.all().concat(FIXTURES.slice(0, Effort.choose(2, 3)).map(function(address:String, ...rest):Model
                    {
                        return read(address);
                    }));
        }

        private static function read(address:String):Model
        {
            return /obj$/.test(address) ? new ObjModel("bear", Fixtures.text(address)) : new ColladaModel("dragon", Fixtures.text(address));
        }

        private static function hierarchyOf(model:Model, maxDepth:int):ModelTree
        {
            var tree:ModelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
            tree.beginBuilding(5, maxDepth, false, false);
            tree.finishBuilding();
            return tree;
        }
    }
}
