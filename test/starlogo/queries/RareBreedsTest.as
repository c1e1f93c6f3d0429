package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.engine;
    import starlogo.queries.trees.RowTree;

    use namespace engine;

    /** Questions about a breed that few of many agents have: what they look at besides, and that breeds may change between them. */
    public class RareBreedsTest
    {
        private static const SHEEP:int = 3000;

        // A question looks at the rows of the asker's leaf and of the wolf's.
        private static const MOST_PASSED_OVER:int = 60;

        // The rare breed. Its bit is not that of the sheep, however many breeds the tests before have made.
        private var _wolves:String;

        private var _agents:Vector.<Agent>;
        private var _seen:SeenAgents;
        private var _places:AgentPlaces;

        [Before]
        public function begin():void
        {
            _wolves = "wolves";
            while (RowTree.breedBit(Breeds.NAMES.numberOf(_wolves)) == RowTree.breedBit(Breeds.NAMES.numberOf("sheep")))
            {
                _wolves += "!";
            }
            var random:SeededRandom = new SeededRandom(406);
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < SHEEP; i++)
            {
                var sheep:Agent = new Agent("sphere", "sheep");
                sheep.moveTo(random.between(-90, 90), random.between(-90, 90), 0);
                _agents.push(sheep);
            }
            var wolf:Agent = new Agent("sphere", _wolves);
            wolf.moveTo(400, 300, 0);
            _agents.push(wolf);
            _seen = new SeenAgents(new BinCollider());
            _places = new AgentPlaces(_seen);
            _seen.update(_agents);
        }

        [Test]
        public function theOneFarWolfIsNearestToAllSheep():void
        {
            var wolves:AgentFilter = AgentFilter.ofBreeds(_wolves, "nobody's");
            assertFew(_seen.treeOfPlaces(), function(sheep:Agent):void
                {
                    assertStrictlyEquals(_agents[SHEEP], _places.nearest(sheep, Infinity, wolves));
                });
        }

        [Test]
        public function manyAreNearAndNoneOfThemCounts():void
        {
            var wolves:AgentFilter = AgentFilter.ofBreeds(_wolves);
            assertFew(_seen.treeOfPlaces(), function(sheep:Agent):void
                {
                    assertEquals(0, _places.countNear(sheep, 200, wolves));
                });
            assertFew(_seen.treeOfPlaces(), function(sheep:Agent):void
                {
                    assertEquals(0, _places.inCone(sheep, 200, 90, wolves, null).length);
                });
        }

        [Test]
        public function aLargeBodyTouchesTheWolfAmongAllSheep():void
        {
            var large:Sphere = new Sphere(new Vector3D(), 2000);
            var wolves:AgentFilter = AgentFilter.ofBreeds(_wolves);
            assertFew(_seen.treeOfExtents(), function(sheep:Agent):void
                {
                    assertStrictlyEquals(_agents[SHEEP], new TouchQueries(_seen).overlapping(large, wolves, null)[0]);
                });
        }

        [Test]
        public function whoGetsTheBreedIsFoundAtOnce():void
        {
            var wolves:AgentFilter = AgentFilter.ofBreeds(_wolves);
            for (var i:int = 0; i < 400; i++)
            {
                var sheep:Agent = _agents[i];
                var bitten:Agent = _agents[SHEEP - 1 - i % 40];
                if (i % 40 == 20)
                {
                    bitten.breed = _wolves;
                }
                var nearest:Agent = _places.nearest(sheep, Infinity, wolves);
                assertStrictlyEquals("question " + i, nearestOf(_wolves, sheep), nearest);
                if (i % 40 == 30)
                {
                    nearest.breed = "sheep";
                }
            }
        }

        // The set of a question has a bit for each of 32 breeds. Only a program without more of them reaches the border of that.
        [Test]
        public function newNamesInAFilterExcludeNoBreedThatSharesTheirBit():void
        {
            while (Breeds.NAMES.count < 32)
            {
                Breeds.NAMES.numberOf("breed " + Breeds.NAMES.count);
            }
            var only:Agent = new Agent("sphere", Breeds.NAMES.nameOf(3));
            _seen.update(new <Agent>[only]);
            // the tree learns the breeds after a question about another breed
            assertNull(_places.nearestToPoint(new Vector3D(), Infinity, AgentFilter.ofBreeds(Breeds.NAMES.nameOf(4))));
            var filter:AgentFilter = new AgentFilter();
            filter.exceptBreeds = new <String>["new A", "new B", "new C", "new D"];
            assertStrictlyEquals(only, _places.nearestToPoint(new Vector3D(), Infinity, filter));
        }

        // A question in accepts makes the nodes learn their breeds, when one of them has a new breed with the bit of an excepted one.
        [Test]
        public function aBreedThatAcceptsMakesIsNotExceptedByItsBit():void
        {
            while (Breeds.NAMES.count < 32)
            {
                Breeds.NAMES.numberOf("breed " + Breeds.NAMES.count);
            }
            var excepted:String = Breeds.NAMES.nameOf(4);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 200; i++)
            {
                var agent:Agent = new Agent("sphere", Breeds.NAMES.nameOf(5));
                agent.x = i;
                agents.push(agent);
            }
            _seen.update(agents);
            var asked:int = 0;
            var filter:AgentFilter = new AgentFilter();
            filter.exceptBreeds = new <String>[excepted];
            filter.accepts = function(agent:Agent):Boolean
            {
                if (asked == 0)
                {
                    while (RowTree.breedBit(Breeds.NAMES.count) != RowTree.breedBit(4))
                    {
                        Breeds.NAMES.numberOf("breed " + Breeds.NAMES.count);
                    }
                    for (var last:int = 0; last < 100; last++)
                    {
                        agents[100 + last].breed = "the newest";
                    }
                    // the first two pass over all, and the last lets the nodes learn
                    for (var question:int = 0; question < 3; question++)
                    {
                        _places.countNear(agent, Infinity, AgentFilter.ofBreeds(excepted));
                    }
                }
                asked++;
                return agent.breed == "the newest";
            };
            assertStrictlyEquals(agents[100], _places.nearestToPoint(new Vector3D(), Infinity, filter));
        }

        // Asks for all sheep: how many rows that do not count are looked at.
        private function assertFew(tree:RowTree, ask:Function):void
        {
            var sum:int = 0;
            for (var i:int = 0; i < SHEEP; i++)
            {
                var before:int = tree.excludedCount;
                ask(_agents[i]);
                // learning begins anew
                sum += tree.excludedCount < before ? tree.excludedCount : tree.excludedCount - before;
            }
            assertTrue(sum + " rows", sum < SHEEP * MOST_PASSED_OVER);
        }

        private function nearestOf(breed:String, asker:Agent):Agent
        {
            var nearest:Agent = null;
            var least:Number = Infinity;
            for each (var agent:Agent in _agents)
            {
                var square:Number = (agent.x - asker.x) * (agent.x - asker.x) + (agent.y - asker.y) * (agent.y - asker.y);
                if (agent !== asker && agent.breed == breed && square < least)
                {
                    least = square;
                    nearest = agent;
                }
            }
            return nearest;
        }
    }
}
