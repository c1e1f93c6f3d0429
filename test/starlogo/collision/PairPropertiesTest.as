package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.BruteForce;
    import support.Effort;
    import support.Fixtures;

    /**
     * What holds for every pair in every collider: a search finds what areColliding says, in whichever order the two are given.
     * With -Dfull on 895,068 pairs for each of five colliders.
     */
    public class PairPropertiesTest
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/fortress.obj", "/assets/kelp.obj"];

        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "bear", "fortress", "kelp"];
        private static const AGENTS_A_WORLD:int = 24;

        private static var sGreatLand:GreatLand;

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.addModel(BuiltInModel.sphere());
            sGreatLand.addModel(BuiltInModel.cube());
            sGreatLand.addModel(BuiltInModel.cylinder());
            for each (var name:String in ["bear", "fortress", "kelp"])
            {
                sGreatLand.addModel(new ObjModel(name, Fixtures.text("/assets/" + name + ".obj")));
            }
        }

        [AfterClass]
        public static function unload():void
        {
            sGreatLand = null;
        }

        [Test(timeout="3600000")]
        public function unitSpheresAreFoundAsAsked():void
        {
            findsWhatItIsAsked(new BinCollider(sGreatLand));
        }

        [Test(timeout="3600000")]
        public function tightestFitsAreFoundAsAsked():void
        {
            findsWhatItIsAsked(new TightestFitCollider(sGreatLand));
        }

        [Test(timeout="3600000")]
        public function hierarchiesAreFoundAsAsked():void
        {
            findsWhatItIsAsked(new HierarchicalCollider(sGreatLand));
        }

        [Test(timeout="3600000")]
        public function combinationsAreFoundAsAsked():void
        {
            findsWhatItIsAsked(new CombinationCollider(sGreatLand));
        }

        [Test(timeout="3600000")]
        public function modelsAreFoundAsAsked():void
        {
            findsWhatItIsAsked(exactCollider());
        }

        // Where two that approach begin to touch, rounding decides, and must decide the same for (a, b) and (b, a).
        [Test(timeout="600000")]
        public function orderDoesNotMatterWhereRoundingDecides():void
        {
            var random:SeededRandom = new SeededRandom(703);
            var count:int = Effort.choose(40, 600);
            var flips:int = 0;
            for each (var collider:CollisionSystem in colliders())
            {
                for (var i:int = 0; i < count; i++)
                {
                    var a:Agent = randomAgent(random);
                    var b:Agent = randomAgent(random);
                    flips += flipsAtTheBorder(collider, a, b);
                }
                trace("  " + flips + " borders between touching and not");
            }
            assertTrue(flips > 3 * count);
        }

        private static function findsWhatItIsAsked(collider:CollisionSystem):void
        {
            var random:SeededRandom = new SeededRandom(701);
            var worlds:int = Effort.choose(12, 3243);
            var agents:Vector.<Agent> = randomWorld(random);
            var found:Vector.<Agent> = new Vector.<Agent>();
            var pairs:int = 0;
            var collisions:int = 0;
            for (var world:int = 0; world < worlds; world++)
            {
                for each (var agent:Agent in agents)
                {
                    change(agent, random);
                }
                collider.findCollisions(agents, found);
                var next:int = 0;
                for (var i:int = 0; i < agents.length; i++)
                {
                    for (var j:int = i + 1; j < agents.length; j++)
                    {
                        var isHit:Boolean = collider.areColliding(agents[i], agents[j]);
                        if (isHit != collider.areColliding(agents[j], agents[i]))
                        {
                            fail("world " + world + ": " + agents[i] + " and " + agents[j] + " the other way round");
                        }
                        next += isHit ? 2 : 0;
                    }
                }
                assertEquals("world " + world, next, found.length);
                if (world % 20 == 0)
                {
                    assertEquals("world " + world, "", BruteForce.difference(BruteForce.ask(collider, agents), found));
                }
                agents.reverse();
                pairs += AGENTS_A_WORLD * (AGENTS_A_WORLD - 1) / 2;
                collisions += found.length / 2;
            }
            trace("  " + collider + ": " + pairs + " pairs, " + collisions + " collide");
            assertTrue(collisions > pairs / 40 && collisions < pairs / 2);
        }

        // Bisects to the last bit of b's x between a hit and a miss, then asks around it.
        private static function flipsAtTheBorder(collider:CollisionSystem, a:Agent, b:Agent):int
        {
            b.moveTo(a.x, a.y, a.z);
            if (!collider.areColliding(a, b))
            {
                return 0;
            }
            var hit:Number = b.x;
            var miss:Number = a.x + 20;
            for (var i:int = 0; i < 70; i++)
            {
                var middle:Number = (hit + miss) / 2;
                b.x = middle;
                var isHit:Boolean = collider.areColliding(a, b);
                assertEquals(a + ", " + b + " at " + middle, isHit, collider.areColliding(b, a));
                if (isHit)
                {
                    hit = middle;
                }
                else
                {
                    miss = middle;
                }
            }
            return 1;
        }

        private static function colliders():Array
        {
            return [new BinCollider(sGreatLand), new TightestFitCollider(sGreatLand), new HierarchicalCollider(sGreatLand),
                    new CombinationCollider(sGreatLand), exactCollider()];
        }

        private static function exactCollider():HierarchicalCollider
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(sGreatLand);
            collider.exact = true;
            return collider;
        }

        private static function randomWorld(random:SeededRandom):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < AGENTS_A_WORLD; i++)
            {
                agents.push(randomAgent(random));
            }
            return agents;
        }

        private static function randomAgent(random:SeededRandom):Agent
        {
            var agent:Agent = new Agent("sphere");
            change(agent, random);
            return agent;
        }

        private static function change(agent:Agent, random:SeededRandom):void
        {
            agent.shape = random.pick(SHAPES);
            agent.moveTo(random.between(-2, 2), random.between(-2, 2), random.between(0, 1));
            agent.size = random.logBetween(0.2, 2);
            agent.heading = random.pick([0, 90, random.between(0, 360)]);
            agent.pitch = random.pick([0, 0, random.between(0, 360)]);
            agent.roll = random.pick([0, 0, random.between(0, 360)]);
            agent.hierarchical = random.chance(0.3);
        }
    }
}
