package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.search.table.AgentTable;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** A motion begins where the last search saw the agent. */
    public class RowMotionsTest
    {
        private var _tests:NarrowPhase = new NarrowPhase(new TightestFitChoice(landOf(BuiltInModel.cube())));
        private var _table:AgentTable = new AgentTable(_tests.shapeChoice);
        private var _motions:RowMotions = new RowMotions(_table);
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
        public function aRefusedListChangesNoPlaceOfTheSearchesBeforeAndAfterIt():void
        {
            var random:SeededRandom = new SeededRandom(742);
            for each (var sweeping:Agent in _agents)
            {
                sweeping.sweeps = true;
            }
            var listed:Vector.<Agent> = _agents.concat();
            var lastList:Vector.<Agent> = listed;
            // by id, the place in the last search
            var seen:Object = {};
            noteSeen(listed, seen);
            var still:int = 0;
            var refused:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                for each (var agent:Agent in _agents)
                {
                    if (random.chance(0.4))
                    {
                        agent.moveTo(random.between(-9, 9), 0, 0);
                    }
                }
                if (random.chance(0.3))
                {
                    listed = someOf(_agents, random);
                }
                if (random.chance(0.4))
                {
                    var wrong:Agent = random.chance() ? null : new Agent("unknown");
                    assertThrows(ArgumentError, /null|there is no model/, _table.readBodies, listed.concat(new <Agent>[wrong]));
                    assertLastPlaces(lastList, seen);
                    refused++;
                    continue;
                }
                _table.readBodies(listed);
                _motions.read();
                _table.readPlaces();
                for each (agent in listed)
                {
                    var row:int = _table.listed.rowOf(agent);
                    var wasListed:Boolean = lastList.indexOf(agent) >= 0;
                    assertEquals("has a motion", wasListed, _motions.areSweeping[row]);
                    if (wasListed)
                    {
                        assertEquals("where the motion begins", agent.x - seen[agent.id], _motions.displacements.x[row]);
                        still += seen[agent.id] == agent.x ? 1 : 0;
                    }
                }
                lastList = listed;
                noteSeen(listed, seen);
                assertLastPlaces(listed, seen);
            }
            assertTrue(still + " still, " + refused + " refused", still > 300 && refused > 80 && refused < 160);
        }

        private static function someOf(agents:Vector.<Agent>, random:SeededRandom):Vector.<Agent>
        {
            var some:Vector.<Agent> = new Vector.<Agent>();
            for each (var agent:Agent in agents)
            {
                if (random.chance(0.9))
                {
                    some.push(agent);
                }
            }
            return some;
        }

        private static function noteSeen(agents:Vector.<Agent>, seen:Object):void
        {
            for each (var agent:Agent in agents)
            {
                seen[agent.id] = agent.x;
            }
        }

        private function assertLastPlaces(listed:Vector.<Agent>, seen:Object):void
        {
            for each (var agent:Agent in listed)
            {
                assertEquals(seen[agent.id], _table.places.x[_table.listed.rowOf(agent)]);
            }
        }
    }
}
