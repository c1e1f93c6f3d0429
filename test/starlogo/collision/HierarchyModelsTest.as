package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.EveryTriangle;
    import support.Fixtures;
    import support.PlacementTally;
    import evaluation.pairs.SeededRandom;

    /**
     * The game's own models at random places, any rotation, sizes 0.3 to 5, against every triangle of each: hierarchies miss
     * nothing at any depth, exact ones are right.
     */
    public class HierarchyModelsTest
    {
        public static const FIXTURES:Array = ["/assets/kelp.obj", "/assets/spaceship.obj", "/assets/fortress.obj", "/assets/tree.obj",
                "/assets/bear.obj", "/assets/person.dae"];

        private static var sModels:Object;

        [BeforeClass]
        public static function readModels():void
        {
            sModels = {};
            for each (var address:String in FIXTURES)
            {
                sModels[address] = /obj$/.test(address) ? new ObjModel(address, Fixtures.text(address)) : new ColladaModel(address, Fixtures.text(address));
            }
        }

        [AfterClass]
        public static function forgetModels():void
        {
            sModels = null;
        }

        [Test]
        public function anyRotation():void
        {
            compare(701, false);
        }

        [Test]
        public function moreOfAnyRotation():void
        {
            compare(702, false);
        }

        [Test]
        public function onTheGround():void
        {
            compare(703, true);
        }

        [Test]
        public function moreOnTheGround():void
        {
            compare(704, true);
        }

        private static function compare(seed:uint, isUpright:Boolean):void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(openModels());
            var random:SeededRandom = new SeededRandom(seed);
            var tallies:Object = {};
            var wrong:int = 0;
            var placements:int = Effort.choose(25, 100);
            for (var i:int = 0; i < placements; i++)
            {
                var a:Agent = randomAgent(random, isUpright);
                var b:Agent = randomAgent(random, isUpright);
                var doMeet:Boolean = EveryTriangle.meet(a, sModels[a.shape], b, sModels[b.shape]);
                collider.exact = true;
                wrong += collider.areColliding(a, b) == doMeet ? 0 : 1;
                collider.exact = false;
                for each (var depth:int in [1, 3, 5, 10])
                {
                    tallies[depth] ||= new PlacementTally((isUpright ? "own models upright, depth " : "own models, depth ") + depth);
                    collider.maxDepth = depth;
                    tallies[depth].add(collider.areColliding(a, b), doMeet);
                }
            }
            assertEquals("exact", 0, wrong);
            for each (var tally:PlacementTally in tallies)
            {
                trace(tally);
                assertEquals(tally.name, 0, tally.missed);
                assertTrue("some meet, some do not", tally.found > placements / 10 && tally.found < 0.9 * placements);
            }
        }

        // A triangle that is there twice leaves a surface as it is, and not closed: surfaces alone count then.
        private static function openModels():GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadTightestFit = false;
            for each (var address:String in FIXTURES)
            {
                var model:Model = sModels[address];
                var triangles:Vector.<uint> = model.triangles.slice();
                triangles.fixed = false;
                triangles.push(triangles[0], triangles[1], triangles[2]);
                greatLand.addModel(new Model(address, model.vertices, triangles));
            }
            return greatLand;
        }

        private static function randomAgent(random:SeededRandom, isUpright:Boolean):Agent
        {
            var agent:Agent = new Agent(random.pick(FIXTURES));
            agent.size = random.logBetween(0.3, 5);
            agent.heading = random.between(0, 360);
            var reach:Number = 0.5 * agent.size;
            agent.moveTo(random.between(-reach, reach), random.between(-reach, reach), 0);
            if (!isUpright)
            {
                agent.pitch = random.between(0, 360);
                agent.roll = random.between(0, 360);
                agent.z = random.between(-reach, reach);
            }
            return agent;
        }
    }
}
