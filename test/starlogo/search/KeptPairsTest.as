package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.landOf;

    /**
     * A frame in which few agents have changed tests these agents alone, and makes the calls of a frame that tests all, in the same order.
     * test/fuzz/kept.mjs plays many more such games.
     */
    public class KeptPairsTest
    {
        private static const BREEDS:Array = ["walls", "coins", "movers"];

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _random:SeededRandom = new SeededRandom(52);

        [Test]
        public function aFrameWithoutChangesTestsNothing():void
        {
            for each (var system:CollisionSystem in [new BinCollider(_greatLand), new TightestFitCollider(_greatLand), new HierarchicalCollider(_greatLand)])
            {
                var collision:Collision = new Collision(system);
                var calls:Array = [];
                listen(collision, calls);
                var agents:Vector.<Agent> = scattered(200, 12);
                collision.update(agents);
                collision.update(agents);
                var collisions:int = collision.statistics.collisions;
                assertTrue(collisions > 20 && collision.statistics.candidatePairs >= collisions);
                collision.update(agents);
                assertEquals(0, collision.statistics.candidatePairs);
                assertEquals(0, collision.statistics.tests + collision.statistics.hierarchyTests);
                assertEquals(collisions, collision.statistics.collisions);
                assertEquals(200, collision.statistics.agents);
            }
        }

        [Test]
        public function oneThatMovesIsTestedWithThoseNearIt():void
        {
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            listen(collision, []);
            var agents:Vector.<Agent> = scattered(200, 12);
            collision.update(agents);
            collision.update(agents);
            var all:int = collision.statistics.candidatePairs;
            for (var i:int = 0; i < 5; i++)
            {
                agents[7].x += 0.1;
                collision.update(agents);
                assertTrue(collision.statistics.candidatePairs > 0 && 10 * collision.statistics.candidatePairs < all);
            }
        }

        [Test]
        public function theCallsAreThoseOfASearchOfAll():void
        {
            var tests:int = 0;
            var testsOfAll:int = 0;
            for (var game:int = 0; game < 6; game++)
            {
                var isHierarchical:Boolean = game % 3 == 2;
                var kept:Collision = new Collision(isHierarchical ? new HierarchicalCollider(_greatLand) : new TightestFitCollider(_greatLand));
                var full:Collision = new Collision(isHierarchical ? new HierarchicalCollider(_greatLand) : new TightestFitCollider(_greatLand));
                var calls:Array = [];
                var callsOfAll:Array = [];
                listen(kept, calls);
                listen(full, callsOfAll);
                kept.terrain = full.terrain = game < 2 ? null : new Terrain(14, 14, 1, -7, -7);
                kept.bounds = full.bounds = game < 2 ? null : new WorldBounds(-5, -5, -5, 5, 5, 5);
                var agents:Vector.<Agent> = scattered(120, 12);
                for (var frame:int = 0; frame < 40; frame++)
                {
                    for (var i:int = 0; i < 4; i++)
                    {
                        change(agents, game > 3);
                    }
                    if (kept.terrain != null && frame % 15 == 7)
                    {
                        kept.terrain.raiseMound(0, 0, 4, 1);
                    }
                    kept.update(agents);
                    full.update(agents);
                    // from here on it keeps nothing but its motions and touches
                    full.restore(full.snapshot(), agents.concat());
                    assertEquals("game " + game + ", frame " + frame, callsOfAll.join("\n"), calls.join("\n"));
                    assertEquals(full.statistics.agentsSkipped, kept.statistics.agentsSkipped);
                    calls.length = callsOfAll.length = 0;
                    tests += kept.statistics.candidatePairs;
                    testsOfAll += full.statistics.candidatePairs;
                }
            }
            assertTrue("most frames test few pairs: " + tests + " of " + testsOfAll, 2 * tests < testsOfAll);
        }

        private function change(agents:Vector.<Agent>, sweeps:Boolean):void
        {
            var at:int = int(_random.next() * agents.length);
            var agent:Agent = agents[at];
            var what:Number = _random.next();
            if (what < 0.7)
            {
                agent.moveTo(agent.x + _random.next() - 0.5, agent.y + _random.next() - 0.5, agent.z);
            }
            else if (what < 0.75)
            {
                agent.jumpTo(12 * _random.next() - 6, 12 * _random.next() - 6, 0);
            }
            else if (what < 0.8)
            {
                agent.heading += 30;
            }
            else if (what < 0.84)
            {
                agent.breed = BREEDS[int(_random.next() * BREEDS.length)];
            }
            else if (what < 0.88)
            {
                agent.size = _random.next() < 0.2 ? 5 : 0.5 + _random.next();
            }
            else if (what < 0.92)
            {
                agents.push(scattered(1, 12)[0]);
            }
            else if (what < 0.94)
            {
                agents.splice(at, 1);
            }
            else if (what < 0.97)
            {
                // the last one takes the place of one that leaves
                var last:Agent = agents.pop();
                agents[Math.min(at, agents.length - 1)] = last;
            }
            else
            {
                agent.sweeps = sweeps && !agent.sweeps;
            }
        }

        private static function listen(collision:Collision, calls:Array):void
        {
            function called(what:String):Function
            {
                return function(a:Agent, b:Agent):void
                {
                    calls.push(what + " " + a.id + " " + b.id);
                };
            }
            collision.onCollision("movers", Collision.ANY_BREED, called("with"));
            collision.onCollision("walls", "walls", called("walls"));
            collision.onCollision("coins", Collision.TERRAIN, called("ground"));
            collision.onCollision("movers", Collision.EDGE, called("edge"));
            collision.onCollisionStart("movers", "coins", called("start"));
            collision.onCollisionEnd(Collision.ANY_BREED, "movers", called("end"));
        }

        private function scattered(count:int, side:Number):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(_random.next() < 0.5 ? "sphere" : "cube", BREEDS[int(_random.next() * BREEDS.length)]);
                agent.moveTo(side * (_random.next() - 0.5), side * (_random.next() - 0.5), 0);
                agent.heading = 360 * _random.next();
                agents.push(agent);
            }
            return agents;
        }
    }
}
