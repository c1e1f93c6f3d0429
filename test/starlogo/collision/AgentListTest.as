package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;

    public class AgentListTest
    {
        // What the class promises, and a bisection of 10,000 for each question.
        private static const COMPARISONS_EACH:int = 32 + 14;

        private var _list:AgentList;
        private var _agents:Vector.<Agent>;
        private var _all:Vector.<Agent>;
        private var _random:SeededRandom;
        private var _questions:int;

        [Before]
        public function makeList():void
        {
            _random = new SeededRandom(77);
            _list = new AgentList();
            _questions = 0;
        }

        [Test]
        public function takingOutByThousandsStaysProportional():void
        {
            begin(3000);
            for (var i:int = 0; i < 1000; i++)
            {
                var gone:Agent = _agents[_random.integer(0, _agents.length - 1)];
                _agents.splice(_agents.indexOf(gone), 1);
                askAbout(gone);
                askAbout(anyone());
                askAbout(anyone());
            }
            assertInProportion();
        }

        [Test]
        public function poppingIsNoticed():void
        {
            begin(2000);
            for (var i:int = 0; i < 500; i++)
            {
                askAbout(_agents.pop());
                askAbout(anyone());
            }
            assertInProportion();
        }

        [Test]
        public function swappingWithTheLastIsNoticed():void
        {
            begin(2000);
            for (var i:int = 0; i < 500; i++)
            {
                var index:int = _random.integer(0, _agents.length - 1);
                var gone:Agent = _agents[index];
                _agents[index] = _agents[_agents.length - 1];
                _agents.pop();
                askAbout(gone);
                if (index < _agents.length)
                {
                    assertTrue("the one that took its place is there", ask(_agents[index]));
                }
                askAbout(anyone());
            }
            assertInProportion();
        }

        [Test]
        public function aLongListInAnyOrderIsInDoubtRatherThanWrong():void
        {
            begin(1000);
            var doubts:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                _agents.reverse();
                _agents.push(_agents.shift());
                var agent:Agent = anyone();
                if (!ask(agent))
                {
                    assertTrue("it is there", _list.isInDoubt);
                    doubts++;
                }
            }
            assertTrue(doubts + " doubts", doubts > 0);
            _list.begin(_agents);
            for each (agent in _all)
            {
                assertTrue("looked at anew", ask(agent));
            }
        }

        [Test]
        public function shortListsAreNeverInDoubt():void
        {
            begin(20);
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
                    assertFalse(_list.isInDoubt);
                }
            }
        }

        [Test]
        public function whoIsGoneStaysGone():void
        {
            begin(10);
            var gone:Agent = _agents.pop();
            assertFalse(ask(gone));
            _agents.push(gone);
            assertFalse("in this frame", ask(gone));
            _list.begin(_agents);
            assertTrue("not in the next", ask(gone));
        }

        [Test]
        public function whoCameInMeanwhileIsThere():void
        {
            begin(10);
            var added:Agent = new Agent("sphere");
            assertEquals(false, ask(new Agent("sphere")));
            _agents.unshift(added);
            assertTrue(ask(added));
            for each (var agent:Agent in _all)
            {
                assertTrue(ask(agent));
            }
        }

        private function begin(count:int):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                _agents.push(new Agent("sphere"));
            }
            _all = _agents.concat();
            _list.begin(_agents);
        }

        private function anyone():Agent
        {
            return _all[_random.integer(0, _all.length - 1)];
        }

        private function ask(agent:Agent):Boolean
        {
            _questions++;
            return _list.contains(_list.recordOf(agent), _questions);
        }

        private function askAbout(agent:Agent):void
        {
            var isThere:Boolean = ask(agent);
            if (!_list.isInDoubt)
            {
                assertEquals(_agents.indexOf(agent) >= 0, isThere);
            }
        }

        private function assertInProportion():void
        {
            var allowed:Number = COMPARISONS_EACH * (_all.length + _questions);
            assertTrue(_list.comparisons + " comparisons, " + allowed + " allowed", _list.comparisons <= allowed);
        }
    }
}
