package starlogo.handlers
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;

    public class AgentListTest
    {
        private var _list:AgentList;
        private var _agents:Vector.<Agent>;
        private var _all:Vector.<Agent>;
        private var _random:SeededRandom;

        [Before]
        public function makeList():void
        {
            _random = new SeededRandom(77);
            _list = new AgentList();
        }

        [Test]
        public function takenOutByThousands():void
        {
            listAgents(3000);
            for (var i:int = 0; i < 1000; i++)
            {
                var gone:Agent = randomAgent();
                if (_agents.indexOf(gone) >= 0)
                {
                    _agents.splice(_agents.indexOf(gone), 1);
                }
                askAbout(gone);
                askAbout(randomAgent());
                askAbout(randomAgent());
            }
        }

        [Test]
        public function thousandsOfSearchesLookAtFewEntries():void
        {
            listAgents(10000);
            _agents.shift();
            assertTrue("all one place nearer to the beginning: " + askAboutAll(), _list.looked < 40000);
            // none is where it was, nor before that
            _agents.reverse();
            _list.setAgents(_agents);
            _list.indexOf(_agents[0]);
            _agents.reverse();
            assertTrue("turned round: " + askAboutAll(), _list.looked < 60000);
        }

        [Test]
        public function manyThatGoWhileOthersAreAskedAboutCostLittle():void
        {
            listAgents(10000);
            for (var i:int = 0; i < 2000; i++)
            {
                _agents.splice(_random.integer(0, 99), 1);
                assertTrue(ask(_agents[_random.integer(100, _agents.length - 1)]));
            }
            // 2,000 searches of the whole list would be 20 million
            assertTrue(String(_list.looked), _list.looked < 1000000);
        }

        private function askAboutAll():int
        {
            for each (var agent:Agent in _all)
            {
                _list.contains(agent);
            }
            return _list.looked;
        }

        [Test]
        public function aShortListInAnyOrder():void
        {
            listAgents(20);
            for (var i:int = 0; i < 30; i++)
            {
                _agents.reverse();
                if (i % 3 == 0)
                {
                    _agents.splice(_random.integer(0, _agents.length - 1), 1);
                }
                for each (var agent:Agent in _all)
                {
                    askAbout(agent);
                }
            }
        }

        [Test]
        public function anAgentThatIsGoneStaysGone():void
        {
            listAgents(10);
            var gone:Agent = _agents.pop();
            assertFalse(ask(gone));
            _agents.push(gone);
            assertFalse("in this frame", ask(gone));
            // so many searches that the whole list is looked at anew
            for (var i:int = 0; i < 30; i++)
            {
                _agents.reverse();
                assertTrue(ask(_all[i % 9]));
            }
            assertFalse("in this frame", ask(gone));
            _list.setAgents(_agents);
            assertTrue("not in the next", ask(gone));
        }

        [Test]
        public function anAgentThatCameInMeanwhileWaitsForTheNextFrame():void
        {
            listAgents(10);
            var added:Agent = new Agent("sphere");
            assertFalse(ask(new Agent("sphere")));
            _agents.unshift(added);
            assertFalse(ask(added));
            for each (var agent:Agent in _all)
            {
                assertTrue(ask(agent));
            }
            _list.setAgents(_agents);
            assertTrue(ask(added));
        }

        [Test]
        public function aListMayHaveHoles():void
        {
            listAgents(10);
            for (var i:int = 0; i < 10; i += 3)
            {
                _agents[i] = null;
            }
            for each (var agent:Agent in _all)
            {
                askAbout(agent);
            }
            _list.setAgents(_agents);
            assertEquals(-1, _list.indexOf(_all[0]));
            assertEquals(1, _list.indexOf(_all[1]));
        }

        private function listAgents(count:int):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                _agents.push(new Agent("sphere"));
            }
            _all = _agents.concat();
            _list.setAgents(_agents);
            _list.indexOf(_agents[0]);
        }

        private function randomAgent():Agent
        {
            return _all[_random.integer(0, _all.length - 1)];
        }

        private function ask(agent:Agent):Boolean
        {
            return _list.contains(agent);
        }

        private function askAbout(agent:Agent):void
        {
            assertEquals(_agents.indexOf(agent) >= 0, ask(agent));
        }
    }
}
