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
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.RandomWorlds;
    import support.ignore;
    import support.landOf;

    /**
     * A frame in which few agents have changed tests these agents alone. test/fuzz/kept.test.mjs plays games in which they change: the calls are
     * those of a frame that tests all.
     */
    public class ChangedRowSearchTest
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
                listen(collision);
                var agents:Vector.<Agent> = scattered(200, 12);
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
            listen(collision);
            var agents:Vector.<Agent> = scattered(200, 12);
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
        public function fewThatMoveHaveThePairsOfASearchOfAll():void
        {
            for (var kind:int = 0; kind < 2; kind++)
            {
                var collision:Collision = new Collision(newSystem(kind));
                var pairs:Array = [];
                collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent):void
                    {
                        note(pairs, a, b);
                    });
                var agents:Vector.<Agent> = scattered(120, 9);
                collision.update(agents);
                var before:String = "";
                var changes:int = 0;
                for (var i:int = 0; i < 25; i++)
                {
                    for (var k:int = _random.integer(1, 4); k > 0; k--)
                    {
                        var agent:Agent = agents[_random.integer(0, agents.length - 1)];
                        agent.moveTo(agent.x + _random.between(-0.7, 0.7), agent.y + _random.between(-0.7, 0.7), 0);
                    }
                    pairs = [];
                    collision.update(agents);
                    assertTrue("few are tested", collision.statistics.candidatePairs < agents.length);
                    var found:String = pairs.sort().join();
                    assertEquals("system " + kind + ", frame " + i, pairsOf(newSystem(kind), agents), found);
                    changes += found != before ? 1 : 0;
                    before = found;
                }
                assertTrue(changes + " changes", changes > 10);
            }
        }

        [Test]
        public function aGameThatAsksAgainHasThePairsOfASearchOfAll():void
        {
            for (var kind:int = 0; kind < 2; kind++)
            {
                var system:CollisionSystem = newSystem(kind);
                var agents:Vector.<Agent> = scattered(120, 9);
                system.findCollisions(agents);
                for (var i:int = 0; i < 25; i++)
                {
                    var agent:Agent = agents[_random.integer(0, agents.length - 1)];
                    agent.moveTo(agent.x + _random.between(-0.7, 0.7), agent.y + _random.between(-0.7, 0.7), 0);
                    assertEquals("system " + kind + ", call " + i, pairsOf(newSystem(kind), agents), pairsOf(system, agents));
                }
                assertTrue("few are tested", system.statistics.candidatePairs < agents.length);
            }
        }

        [Test]
        public function interestsThatGrowMakeTheSearchAnew():void
        {
            var collider:TightestFitCollider = new TightestFitCollider(_greatLand);
            var agents:Vector.<Agent> = scattered(200, 12);
            var interests:BreedInterests = new BreedInterests();
            for each (var breed:String in BREEDS)
            {
                interests.add("walls", breed);
                for (var i:int = 0; i < 3; i++)
                {
                    var expected:Vector.<Agent> = new TightestFitCollider(_greatLand).findCollisionsAmong(agents, interests);
                    assertTrue(expected.length > 0);
                    assertEquals(breed + ", call " + i, expected.join(), collider.findCollisionsAmong(agents, interests).join());
                }
            }
        }

        /** A Collision that goes back to its own snapshot after each frame tests all agents in the next one. A filter leaves out other agents now and then. */
        [Test]
        public function framesWithSweepingAgentsMakeTheCallsOfASearchOfAll():void
        {
            for (var kind:int = 0; kind < 2; kind++)
            {
                var kept:Collision = new Collision(newSystem(kind));
                var full:Collision = new Collision(newSystem(kind));
                var callsOfKept:Array = noted(kept);
                var callsOfFull:Array = noted(full);
                var filter:AgentFilter = new AgentFilter();
                kept.filter = full.filter = filter;
                var agents:Vector.<Agent> = scattered(200, 14);
                var early:int = 0;
                var few:int = 0;
                for (var i:int = 0; i < 40; i++)
                {
                    change(agents, i);
                    filter.except = i % 4 < 2 ? null : new <Agent>[agents[0], agents[_random.integer(1, agents.length - 1)]];
                    callsOfKept.length = callsOfFull.length = 0;
                    kept.update(agents);
                    full.update(agents);
                    assertEquals("system " + kind + ", frame " + i, callsOfFull.join(), callsOfKept.join());
                    if (2 * kept.statistics.candidatePairs < full.statistics.candidatePairs)
                    {
                        few++;
                        early += callsOfKept.join().split(" at 0.").length - 1;
                    }
                    full.restore(full.snapshot(), agents);
                }
                assertTrue("system " + kind + ": " + few + " frames test few, with " + early + " touches on the way", few > 20 && early > 20);
            }
        }

        // Moves some agents, of which some sweep. Sometimes one leaves, or another comes.
        private function change(agents:Vector.<Agent>, frame:int):void
        {
            for (var k:int = 0; k < 3; k++)
            {
                var agent:Agent = agents[_random.integer(0, agents.length - 1)];
                agent.sweeps = k > 0;
                agent.moveTo(agent.x + _random.between(-3, 3), agent.y + _random.between(-3, 3), 0);
            }
            if (frame % 7 == 3)
            {
                agents.splice(_random.integer(0, agents.length - 1), 1);
            }
            else if (frame % 7 == 5)
            {
                agents.push(scattered(1, 14)[0]);
            }
        }

        // The calls that a Collision makes, in their order, with the times of the contacts.
        private static function noted(collision:Collision):Array
        {
            var calls:Array = [];
            collision.onCollision("movers", Collision.ANY_BREED, function(a:Agent, b:Agent, contact:Contact):void
                {
                    calls.push(a.id + " " + b.id + " at " + contact.time);
                });
            collision.onCollisionStart("walls", Collision.ANY_BREED, function(a:Agent, b:Agent):void
                {
                    calls.push(a.id + " begins " + b.id);
                });
            collision.onCollisionEnd(Collision.ANY_BREED, "walls", function(a:Agent, b:Agent):void
                {
                    calls.push(a.id + " ends " + b.id);
                });
            return calls;
        }

        private function newSystem(kind:int):CollisionSystem
        {
            return kind == 0 ? new BinCollider(_greatLand) : new TightestFitCollider(_greatLand);
        }

        [Test]
        public function manyThatAFilterTakesInOrOutAreASearchOfAll():void
        {
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            listen(collision);
            var filter:AgentFilter = new AgentFilter();
            collision.filter = filter;
            var agents:Vector.<Agent> = scattered(200, 12);
            collision.update(agents);
            var all:int = collision.statistics.candidatePairs;
            filter.except = new <Agent>[agents[3], agents[4]];
            collision.update(agents);
            assertTrue("few are out", 10 * collision.statistics.candidatePairs < all);
            filter.except = agents.slice(0, 80);
            collision.update(agents);
            assertTrue("many are out", 10 * collision.statistics.candidatePairs > all);
            var plain:Collision = new Collision(new TightestFitCollider(_greatLand));
            listen(plain);
            plain.update(agents.slice(80));
            assertEquals(plain.statistics.collisions, collision.statistics.collisions);
        }

        [Test]
        public function anotherDepthMakesTheFrameAnew():void
        {
            var land:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cylinder());
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            var collision:Collision = new Collision(collider);
            var pairs:Array = [];
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent):void
                {
                    note(pairs, a, b);
                });
            var agents:Vector.<Agent> = RandomWorlds.mixed(60, ["sphere", "cylinder"], 5, _random);
            collision.update(agents);
            var before:String = "";
            var changes:int = 0;
            for (var i:int = 0; i < 40; i++)
            {
                collider.maxDepth = _random.integer(1, 7);
                pairs = [];
                collision.update(agents);
                var found:String = pairs.sort().join();
                var plain:HierarchicalCollider = new HierarchicalCollider(land);
                plain.maxDepth = collider.maxDepth;
                assertEquals("frame " + i + ", depth " + collider.maxDepth, pairsOf(plain, agents), found);
                changes += found != before ? 1 : 0;
                before = found;
            }
            assertTrue(changes + " changes", changes > 10);
        }

        [Test]
        public function groundThatRisesAndEdgesThatComeNearMeetThoseThatStand():void
        {
            var terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
            var bounds:WorldBounds = new WorldBounds(-20, -20, -20, 20, 20, 20);
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            collision.terrain = terrain;
            collision.bounds = bounds;
            listen(collision);
            var met:Object = {};
            var count:Function = function(a:Agent, b:Agent):void
            {
                met[b.breed] = int(met[b.breed]) + 1;
            };
            collision.onCollision(Collision.ANY_BREED, Collision.TERRAIN, count);
            collision.onCollision(Collision.ANY_BREED, Collision.EDGE, count);
            var agents:Vector.<Agent> = scattered(60, 12);
            for each (var agent:Agent in agents)
            {
                agent.z = 3;
            }
            for (var i:int = 0; i < 5; i++)
            {
                met = {};
                agents[i].x += 0.1;
                collision.update(agents);
                assertEquals("nothing is near, frame " + i, 0, int(met[Collision.TERRAIN]) + int(met[Collision.EDGE]));
            }
            assertTrue("few are tested", collision.statistics.candidatePairs < agents.length);
            terrain.raiseMound(0, 0, 200, 3.1);
            collision.update(agents);
            assertEquals("the ground has risen", 60, int(met[Collision.TERRAIN]));
            bounds.setTo(-20, -20, -20, 20, 20, 3.1);
            met = {};
            collision.update(agents);
            assertEquals("the ground is where it was", 60, int(met[Collision.TERRAIN]));
            assertEquals("the edge has come near", 60, int(met[Collision.EDGE]));
        }

        // The pairs that a search of all finds.
        private static function pairsOf(system:CollisionSystem, agents:Vector.<Agent>):String
        {
            var found:Vector.<Agent> = system.findCollisions(agents);
            var pairs:Array = [];
            for (var i:int = 0; i < found.length; i += 2)
            {
                note(pairs, found[i], found[i + 1]);
            }
            return pairs.sort().join();
        }

        // A handler of any breeds hears of a pair from both sides.
        private static function note(pairs:Array, a:Agent, b:Agent):void
        {
            var pair:String = Math.min(a.id, b.id) + " " + Math.max(a.id, b.id);
            if (pairs.indexOf(pair) < 0)
            {
                pairs.push(pair);
            }
        }

        private static function listen(collision:Collision):void
        {
            collision.onCollision("movers", Collision.ANY_BREED, ignore);
            collision.onCollision("walls", "walls", ignore);
            collision.onCollisionStart("movers", "coins", ignore);
            collision.onCollisionEnd(Collision.ANY_BREED, "movers", ignore);
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
