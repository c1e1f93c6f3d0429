package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.table.ListedAgents;

    /** The order of pairs, compared with a sort by comparisons. */
    public class FoundPairsTest
    {
        private var _random:SeededRandom = new SeededRandom(7215);
        private var _pairs:FoundPairs = new FoundPairs(new ListedAgents());

        [Test]
        public function isThatOfTheList():void
        {
            checkAll(false);
        }

        [Test]
        public function isThatOfTheTimesAndThenOfTheList():void
        {
            checkAll(true);
        }

        // Few pairs are sorted otherwise than many. The same object sorts them all.
        private function checkAll(haveTimes:Boolean):void
        {
            for each (var agentCount:int in [2, 30, 900])
            {
                var list:ListedAgents = listOf(agentCount);
                for each (var pairCount:int in [0, 1, 8, 60, 250])
                {
                    check(list, Math.min(pairCount, agentCount * (agentCount - 1) / 2), haveTimes);
                }
            }
        }

        private function check(list:ListedAgents, pairCount:int, haveTimes:Boolean):void
        {
            _pairs.listed = list;
            _pairs.count = 0;
            var expected:Array = [];
            var timeOf:Object = {};
            var motion:RelativeMotion = new RelativeMotion();
            while (expected.length < pairCount)
            {
                var first:int = _random.integer(0, list.rows.count - 2);
                var second:int = _random.integer(first + 1, list.rows.count);
                var time:Number = haveTimes ? _random.integer(0, 4) / 4 : 0;
                if (timeOf[first + " " + second] == undefined)
                {
                    expected.push([time, first, second]);
                    timeOf[first + " " + second] = time;
                    // after the agents comes the ground
                    var other:int = second == list.rows.count ? ListedAgents.GROUND_ROW : list.rows.values[second];
                    motion.time = time;
                    _pairs.setTime(0, motion);
                    _pairs.addPairs(list.rows.values[first], new <int>[other], 1);
                }
            }
            expected.sort(compare);
            var early:Array = expected.filter(function(each:Array, ...rest):Boolean
                {
                    return haveTimes && each[0] < 1;
                });
            assertEquals("before the end of their motions", early.length, _pairs.putInOrder(haveTimes));
            assertEquals(pairCount, _pairs.count);
            for (var i:int = 0; i < pairCount; i++)
            {
                var found:Array = [0, list.listIndices[_pairs.rows[2 * i]], list.listIndices[_pairs.rows[2 * i + 1]]];
                found[0] = timeOf[found[1] + " " + found[2]];
                assertEquals(i + " of " + pairCount + " pairs of " + list.rows.count, expected[i].join(), found.join());
            }
        }

        private static function compare(a:Array, b:Array):Number
        {
            return a[0] - b[0] || a[1] - b[1] || a[2] - b[2];
        }

        // A list of agents, whose rows have another order.
        private function listOf(count:int):ListedAgents
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                agents.push(new Agent("sphere"));
            }
            var list:ListedAgents = new ListedAgents();
            propose(list, agents);
            for (i = 0; i < count; i++)
            {
                var other:int = _random.integer(0, count - 1);
                var agent:Agent = agents[i];
                agents[i] = agents[other];
                agents[other] = agent;
            }
            propose(list, agents);
            return list;
        }

        private static function propose(list:ListedAgents, agents:Vector.<Agent>):void
        {
            list.propose(agents);
            list.accept(agents);
        }
    }
}
