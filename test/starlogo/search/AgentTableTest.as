package starlogo.search
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** A table has the agents that are listed, and no others: neither those that have left, nor those of a list that was refused. */
    public class AgentTableTest
    {
        private var _land:GreatLand = landOf(BuiltInModel.cube());
        private var _table:AgentTable = new AgentTable(new ModelShapes(new TightestFits(_land)), new Bins());
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        [Before]
        public function makeTable():void
        {
            for (var i:int = 0; i < 20; i++)
            {
                _agents.push(new Agent("cube"));
            }
            _table.read(_agents);
        }

        [Test]
        public function hasNoneOfAListThatIsRefused():void
        {
            for (var i:int = 0; i < 50; i++)
            {
                var others:Vector.<Agent> = _agents.concat().reverse();
                others.splice(10, 5, new Agent("cube"), new Agent("cube"));
                assertThrows(ArgumentError, /null/, _table.read, others.concat(new <Agent>[null]));
                assertThrows(ArgumentError, /twice/, _table.read, others.concat(new <Agent>[others[0]]));
                assertHasOnly(_agents);
                for each (var agent:Agent in _agents)
                {
                    assertTrue(_table.agents[_table.rowOf(agent)] === agent);
                }
            }
            assertTrue(_table.agents.length + " rows", _table.agents.length <= 30);
            _table.read(_agents);
            assertHasOnly(_agents);
        }

        // An agent has a row if it is listed, and only then.
        private function assertHasOnly(listed:Vector.<Agent>):void
        {
            var count:int = 0;
            for (var row:int = 0; row < _table.agents.length; row++)
            {
                var agent:Agent = _table.agents[row];
                var isListed:Boolean = agent != null && listed.indexOf(agent) >= 0;
                count += isListed ? 1 : 0;
                assertTrue("no shape without a listed agent", isListed || _table.shapes[row] == null);
                if (agent != null)
                {
                    // agents of a list that was refused may still have rows
                    assertEquals("the row of " + agent, isListed ? row : -1, _table.rowOf(agent));
                }
            }
            assertEquals(listed.length, count);
        }
    }
}
