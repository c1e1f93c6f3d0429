package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.search.BreedInterests;
    import support.BruteForce;
    import support.Effort;
    import support.RandomWorlds;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    public class BinColliderTest
    {
        private var _worlds:int = Effort.choose(30, 150);

        private var _greatLand:GreatLand = landOf(BuiltInModel.cube());
        private var _collider:BinCollider = new BinCollider(_greatLand);

        [Test]
        public function isAUnitSphereOnTheGround():void
        {
            var a:Agent = agentAt("cube", 0, 0, 0);
            assertTrue("touching along x", _collider.areColliding(a, agentAt("cube", 1, 0, 0)));
            assertFalse("just apart along x", _collider.areColliding(a, agentAt("cube", 1.000001, 0, 0)));
            assertTrue("touching along z", _collider.areColliding(a, agentAt("cube", 0, 0, -1)));
            assertFalse("corner of the cube, outside of the sphere", _collider.areColliding(a, agentAt("cube", 0.8, 0.8, 0)));
        }

        [Test]
        public function withoutAGreatLandAsksForNoModels():void
        {
            var random:SeededRandom = new SeededRandom(25);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var known:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 60; i++)
            {
                agents.push(new Agent("nothing " + i % 7));
                known.push(new Agent("sphere"));
                agents[i].moveTo(random.between(-4, 4), random.between(-4, 4), random.between(0, 2));
                known[i].moveTo(agents[i].x, agents[i].y, agents[i].z);
            }
            var greatLand:GreatLand = landOf(BuiltInModel.sphere());
            var expected:Vector.<Agent> = new BinCollider(greatLand).findCollisions(known);
            var collider:BinCollider = new BinCollider();
            for (var frame:int = 0; frame < 2; frame++)
            {
                var found:Vector.<Agent> = collider.findCollisions(agents);
                assertTrue(found.length > 20 && found.length < 3000);
                assertEquals(expected.length, found.length);
                for (i = 0; i < found.length; i++)
                {
                    assertEquals(known.indexOf(expected[i]), agents.indexOf(found[i]));
                }
            }
            agents[0].shape = "another";
            assertEquals(expected.length, collider.findCollisions(agents).length);
            assertTrue(collider.areColliding(found[0], found[1]));
            assertThrows(ArgumentError, /there is no model "another"/, new BinCollider(greatLand).findCollisions, agents);
        }

        [Test]
        public function worldsOfAllKindsAreLikeBruteForce():void
        {
            for (var i:int = 0; i < RandomWorlds.KINDS.length; i++)
            {
                compareWithBruteForce(RandomWorlds.KINDS[i], 101 + i);
            }
        }

        [Test]
        public function whoTakesPartFarOutOnlyIsFoundThere():void
        {
            var interests:BreedInterests = new BreedInterests();
            interests.add("bears", "bears");
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, 0, 0), agentAt("cube", 0, 0, 0)];
            agents[0].size = agents[1].size = 1e-6;
            var pairs:Vector.<Agent> = new Vector.<Agent>();
            for (var far:Number = 1e4; far <= Agent.LARGEST_COORDINATE; far *= 10)
            {
                agents[0].breed = agents[1].breed = "walls";
                agents[0].moveTo(0, 0, 0);
                agents[1].moveTo(0, 0, 0);
                var collider:BinCollider = new BinCollider(_greatLand);
                collider.findCollisionsAmong(agents, interests, pairs);
                assertEquals("no bears yet", 0, pairs.length);
                agents[0].breed = agents[1].breed = "bears";
                agents[0].moveTo(far, 0, 0);
                // they touch by what rounding comes to there
                agents[1].moveTo(far, 1e-6 + 1e-15 * far, 0);
                assertTrue(collider.areColliding(agents[0], agents[1]));
                collider.findCollisionsAmong(agents, interests, pairs);
                assertEquals("at " + far, 2, pairs.length);
            }
        }

        [Test]
        public function whoSweptFarAndStandsFarOutIsFoundThere():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, 0, 0), agentAt("cube", 0, 0, 0)];
            agents[0].size = agents[1].size = 1e-6;
            for (var far:Number = 1e4; far <= Agent.LARGEST_COORDINATE; far *= 10)
            {
                var collider:BinCollider = new BinCollider(_greatLand);
                agents[0].sweeps = true;
                agents[0].moveTo(far, 0, 0);
                agents[1].moveTo(far, 0, 0);
                collider.findCollisions(agents);
                agents[0].moveTo(0, 0, 0);
                agents[1].moveTo(0, 0, 0);
                collider.findCollisions(agents);
                agents[0].sweeps = false;
                agents[0].moveTo(far, 0, 0);
                agents[1].moveTo(far, 1e-6 + 1e-15 * far, 0);
                assertTrue(collider.areColliding(agents[0], agents[1]));
                assertEquals("at " + far, 2, collider.findCollisions(agents).length);
            }
        }

        [Test]
        public function longWaysAreInOneCell():void
        {
            var ball:Agent = agentAt("cube", -5000, -3000, 0);
            var agents:Vector.<Agent> = new <Agent>[ball, agentAt("cube", 5, 0, 0)];
            ball.size = 0.2;
            ball.sweeps = true;
            _collider.findCollisions(agents);
            ball.moveTo(5000, 3000, 0);
            _collider.findCollisions(agents);
            assertEquals(1, _collider.statistics.candidatePairs);
            assertEquals(1, _collider.statistics.sweptPairs);
            ball.moveTo(-5000, 0, 0);
            _collider.findCollisions(agents);
            ball.moveTo(5000, 0, 0);
            assertEquals(2, _collider.findCollisions(agents).length);
            assertEquals(1, _collider.statistics.sweptPairs);
            assertEquals(1, _collider.statistics.sphereSphereTests);
        }

        [Test]
        public function aCrowdNeedsNoMoreMemoryThanItsPairs():void
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 1000; i++)
            {
                agents.push(agentAt("cube", 7.5, -3.25, i * 1.5));
            }
            assertEquals("stacked, no two touch", 0, _collider.findCollisions(agents).length);
            assertEquals(1000 * 999 / 2, _collider.statistics.candidatePairs);
            for each (var agent:Agent in agents)
            {
                agent.z /= 1.5;
            }
            assertEquals("each touches the next", 2 * 999, _collider.findCollisions(agents).length);
        }

        [Test]
        public function badAgentsAreNamedAndChangeNothing():void
        {
            var a:Agent = agentAt("cube", 0, 0, 0);
            var b:Agent = agentAt("cube", 0.5, 0, 0);
            var out:Vector.<Agent> = new <Agent>[a];
            var unknown:Agent = new Agent("unicorn", "horses");
            assertThrows(ArgumentError, /agents\[1\] is null/, _collider.findCollisions, new <Agent>[a, null], out);
            assertThrows(ArgumentError, /agent \d+ .*listed twice.*agents\[0\].*agents\[2\]/, _collider.findCollisions, new <Agent>[a, b, a], out);
            assertThrows(ArgumentError, /horses.*unicorn.*add it/, _collider.findCollisions, new <Agent>[a, unknown, b], out);
            assertThrows(ArgumentError, /null/, _collider.findCollisions, null, out);
            assertEquals("out is as it was", 1, out.length);
            assertThrows(ArgumentError, /null/, _collider.areColliding, a, null);
            assertThrows(ArgumentError, /unicorn/, _collider.areColliding, a, unknown);
            assertThrows(ArgumentError, /two different agents are needed/, _collider.areColliding, a, a);
            assertThrows(ArgumentError, /two different agents/, _collider.contactOf, a, a);
            assertThrows(ArgumentError, /two agents|must be an Agent/, _collider.contactOf, null, a);
            assertEquals("and the collider still works", 2, _collider.findCollisions(new <Agent>[a, b], out).length);
        }

        [Test]
        public function countsWhatItDoes():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 1, 1, 0), agentAt("cube", 1.2, 1, 0), agentAt("cube", 1, 1, 4), agentAt("cube", 9, 9, 0)];
            _collider.findCollisions(agents);
            var statistics:CollisionStatistics = _collider.statistics;
            assertEquals(4, statistics.agents);
            assertEquals(0, statistics.agentsSkipped);
            assertEquals(3, statistics.candidatePairs);
            assertEquals(3, statistics.sphereSphereTests);
            assertEquals(3, statistics.tests);
            assertEquals(1, statistics.collisions);
        }

        private function compareWithBruteForce(kind:String, seed:uint):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var out:Vector.<Agent> = new Vector.<Agent>();
            var collisions:int = 0;
            var possible:int = 0;
            var tested:int = 0;
            for (var world:int = 0; world < _worlds; world++)
            {
                var count:int = random.logBetween(2, 501);
                var agents:Vector.<Agent> = RandomWorlds.make(kind, count, "cube", random);
                var expected:Vector.<Agent> = BruteForce.spheres(agents);
                assertEquals(kind + ", world " + world, "", BruteForce.difference(expected, _collider.findCollisions(agents, out)));
                collisions += expected.length / 2;
                possible += count * (count - 1) / 2;
                tested += _collider.statistics.candidatePairs;
            }
            trace("  " + kind + ": " + _worlds + " worlds, " + possible + " pairs, " + tested + " tested, " + collisions + " collide");
            assertTrue(kind + ": some collide, some don't", collisions > 50 && collisions < possible);
        }
    }
}
