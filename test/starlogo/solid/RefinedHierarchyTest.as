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
                var hierarchy:SolidHierarchy = hierarchyOf(model, 6);
                var before:String = describe(hierarchy.root);
                hierarchy.prepare();
                assertEquals(model.name, before, describe(hierarchy.root));
            }
        }

        [Test]
        public function leavesHaveFewTrianglesAndBoxesAroundThem():void
        {
            for each (var model:Model in models())
            {
                var hierarchy:SolidHierarchy = hierarchyOf(model, 4);
                hierarchy.prepare();
                var isListed:Vector.<Boolean> = new Vector.<Boolean>(hierarchy.order.length, true);
                for each (var triangle:int in hierarchy.order)
                {
                    assertTrue(!isListed[triangle]);
                    isListed[triangle] = true;
                }
                check(hierarchy.root, hierarchy.solid.extents);
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
            var hierarchy:SolidHierarchy = hierarchyOf(new Model("pile", vertices, triangles), 10);
            assertTrue(hierarchy.root.isLeaf);
            hierarchy.prepare();
            assertTrue(hierarchy.root.isLeaf);
            assertNull(hierarchy.root.left);
            assertEquals(37, hierarchy.root.triangleCount);
            assertEquals(8, check(hierarchy.root, hierarchy.solid.extents));
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
            var hierarchy:SolidHierarchy = hierarchyOf(new Model("needles", vertices, triangles), 10);
            assertEquals("one at a time", 1, hierarchy.root.left.triangleCount);
            hierarchy.prepare();
            check(hierarchy.root, hierarchy.solid.extents);
            var deepest:int = deepestUnder(hierarchy.root);
            assertTrue(deepest + " levels", deepest > 20 && deepest <= Tolerances.NESTED_LEVELS + 12);
        }

        private static function deepestUnder(node:HierarchyNode):int
        {
            return node.goesBelow(int.MAX_VALUE) ? Math.max(deepestUnder(node.low), deepestUnder(node.high)) : node.level;
        }

        [Test]
        public function noDepthLimitReachesBelow():void
        {
            var bear:Model = read(FIXTURES[0]);
            var greatLand:GreatLand = new GreatLand();
            greatLand.hierarchies.maxDepth = 3;
            greatLand.addModel(bear);
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.maxDepth = int.MAX_VALUE;
            var agents:Vector.<Agent> = new <Agent>[new Agent("bear"), new Agent("bear"), new Agent("bear")];
            agents[1].moveTo(0.2, 0.4, 0.1);
            agents[2].moveTo(0.7, 0.5, 0.1);
            agents[2].traversalDepth = int.MAX_VALUE;
            var before:int = visitsOf(collider, agents);
            greatLand.hierarchies.hierarchy("bear").prepare();
            assertEquals(before, visitsOf(collider, agents));
        }

        private static function visitsOf(collider:HierarchicalCollider, agents:Vector.<Agent>):int
        {
            collider.findCollisions(agents);
            assertTrue(collider.statistics.nodeVisits > 0);
            return collider.statistics.nodeVisits;
        }

        // How many leaves there are below a node.
        private static function check(node:HierarchyNode, extents:Vector.<Number>):int
        {
            assertTrue(node.end > node.first);
            for (var i:int = node.first; i < node.end; i++)
            {
                assertTrue(node.x - node.halfX < extents[6 * i] && node.y - node.halfY < extents[6 * i + 1] && node.z - node.halfZ < extents[6 * i + 2]);
                assertTrue(node.x + node.halfX > extents[6 * i + 3] && node.y + node.halfY > extents[6 * i + 4] && node.z + node.halfZ > extents[6 * i + 5]);
            }
            if (!node.goesBelow(int.MAX_VALUE))
            {
                assertNull(node.high);
                assertTrue("triangles: " + (node.end - node.first), node.end - node.first <= MOST);
                return 1;
            }
            assertEquals(node.first, node.low.first);
            assertEquals(node.low.end, node.high.first);
            assertEquals(node.end, node.high.end);
            assertEquals(node.level + 1, node.low.level);
            assertEquals(node.isLeaf ? HierarchyNode.LARGEST_DEPTH : node.level, node.stopDepth);
            assertTrue("below a leaf are leaves", !node.isLeaf || node.low.isLeaf && node.high.isLeaf);
            return check(node.low, extents) + check(node.high, extents);
        }

        private static function describe(node:HierarchyNode):String
        {
            var text:String = [node.level, node.bounds.volume, node.vertexCount, node.triangleIndices()].join(" ");
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

        private static function hierarchyOf(model:Model, maxDepth:int):SolidHierarchy
        {
            return new SolidHierarchyBuilder(new SolidHierarchy(model.vertices, model.triangles, 5, maxDepth, false)).finished;
        }
    }
}
