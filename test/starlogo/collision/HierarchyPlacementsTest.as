package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.models.Model;
    import support.Fixtures;
    import support.PlacementTally;
    import support.Placements;

    /**
     * The colliders against 6,954 placements of pairs of real models, whose surfaces are known to meet or not to. No
     * hierarchy of triangles misses a collision, at any depth; an exact one is right about all. Printed: recall and precision
     * of each collider, and those of the thesis's hierarchies of vertices.
     */
    public class HierarchyPlacementsTest
    {
        public static const FIXTURES:Array = Placements.FIXTURES;

        private static const DEPTHS:Array = [1, 3, 5, 10];
        private static const FULL:int = 60;

        private static var sPlacements:Placements;
        private static var sModels:Vector.<Model>;
        private static var sAgentsA:Object = {};
        private static var sAgentsB:Object = {};

        [BeforeClass]
        public static function loadModels():void
        {
            sPlacements = new Placements();
            sModels = new Vector.<Model>();
            for each (var name:String in sPlacements.names)
            {
                if (sPlacements.hasModel(name))
                {
                    sModels.push(sPlacements.model(name));
                    sAgentsA[name] = new Agent(name);
                    sAgentsB[name] = new Agent(name);
                }
            }
        }

        [Before]
        public function needAllModels():void
        {
            for each (var file:String in FIXTURES)
            {
                Fixtures.assume(file, "the models of assimp and npm are needed");
            }
        }

        [AfterClass]
        public static function forgetModels():void
        {
            sPlacements = null;
            sModels = null;
            sAgentsA = {};
            sAgentsB = {};
        }

        [Test]
        public function binCollider():void
        {
            var greatLand:GreatLand = load(false, true, 1);
            trace(tally("BinCollider", new BinCollider(greatLand)));
        }

        [Test]
        public function tightestFitCollider():void
        {
            trace(tally("TightestFitCollider", new TightestFitCollider(load(true, true, 1))));
        }

        [Test]
        public function hierarchiesOfTrianglesMissNothing():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(load(false, true, 10));
            var precision:Number = 0;
            for each (var depth:int in DEPTHS)
            {
                collider.maxDepth = depth;
                var tallied:PlacementTally = tally("triangles, depth " + depth, collider);
                trace(tallied);
                assertEquals("missed at depth " + depth, 0, tallied.missed);
                assertTrue("deeper is more precise", tallied.precision >= precision);
                precision = tallied.precision;
            }
        }

        [Test]
        public function fullHierarchiesOfTrianglesMissNothing():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(load(false, true, FULL));
            collider.maxDepth = FULL;
            var tallied:PlacementTally = tally("triangles, full", collider);
            trace(tallied);
            assertEquals("missed", 0, tallied.missed);
        }

        [Test]
        public function hierarchiesOfSpheresMissNothing():void
        {
            checkKind(BoundingStructure.SPHERE, "spheres");
        }

        [Test]
        public function hierarchiesOfCapsulesMissNothing():void
        {
            checkKind(BoundingStructure.CAPSULE, "capsules");
        }

        [Test]
        public function hierarchiesOfVerticesMissCollisions():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(load(false, false, FULL));
            for each (var depth:int in DEPTHS.concat(FULL))
            {
                collider.maxDepth = depth;
                var tallied:PlacementTally = tally("vertices, " + (depth == FULL ? "full" : "depth " + depth), collider);
                trace(tallied);
            }
            assertTrue("the thesis's hierarchy has holes", tallied.missed > 0);
        }

        [Test]
        public function exactHierarchiesAreTheModels():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(load(false, true, 10));
            collider.exact = true;
            var wrong:Array = [];
            var insideClosed:int = 0;
            for (var i:int = 0; i < sPlacements.count; i++)
            {
                sPlacements.read(i, sAgentsA, sAgentsB);
                var a:Agent = sAgentsA[sPlacements.nameA];
                var b:Agent = sAgentsB[sPlacements.nameB];
                if (a == null || b == null)
                {
                    continue;
                }
                var isHit:Boolean = collider.areColliding(a, b);
                // inside of a surface that is not closed may be either
                if (isHit != sPlacements.surfacesMeet && !(isHit && sPlacements.isInside))
                {
                    wrong.push(i + ": " + a.shape + ", " + b.shape + (isHit ? " false" : " missed"));
                }
                insideClosed += isHit && sPlacements.isInside ? 1 : 0;
            }
            trace("  exact: " + wrong.length + " wrong, " + insideClosed + " inside of a closed model");
            assertEquals(wrong.slice(0, 10).join("; "), 0, wrong.length);
            assertTrue("some are inside", insideClosed > 0);
        }

        private static function checkKind(kind:int, name:String):void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(load(false, true, 10, kind));
            for each (var depth:int in [5, 10])
            {
                collider.maxDepth = depth;
                var tallied:PlacementTally = tally(name + ", depth " + depth, collider);
                trace(tallied);
                assertEquals("missed at depth " + depth, 0, tallied.missed);
            }
        }

        private static function load(fits:Boolean, triangles:Boolean, maxDepth:int, kind:int = BoundingStructure.BOX):GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.hierarchies.boundsKind = kind;
            greatLand.loadTightestFit = fits;
            greatLand.hierarchies.maxDepth = maxDepth;
            for each (var model:Model in sModels)
            {
                greatLand.addModel(triangles ? model : new Model(model.name, model.vertices));
            }
            return greatLand;
        }

        private static function tally(name:String, collider:BinCollider):PlacementTally
        {
            var tallied:PlacementTally = new PlacementTally(name);
            for (var i:int = 0; i < sPlacements.count; i++)
            {
                sPlacements.read(i, sAgentsA, sAgentsB);
                var a:Agent = sAgentsA[sPlacements.nameA];
                var b:Agent = sAgentsB[sPlacements.nameB];
                if (a != null && b != null)
                {
                    tallied.add(collider.areColliding(a, b), sPlacements.surfacesMeet);
                }
            }
            return tallied;
        }
    }
}
