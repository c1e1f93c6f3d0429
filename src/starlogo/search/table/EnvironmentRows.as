package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.EnvironmentAgent;

    use namespace engine;

    /**
     * The rows of the ground and of the edges of the world in a table. Their agents are given beside the list.
     *
     * @private
     */
    public final class EnvironmentRows
    {
        /** The rows of those that the last <code>read()</code> found changed, or that were others before it. Read only. */
        public var changed:IntList = new IntList();

        private var _table:AgentTable;

        /** @param table has the rows */
        public function EnvironmentRows(table:AgentTable)
        {
            _table = table;
        }

        /** Reads the ground and the edges for a search. Either may be null. */
        public function read(ground:EnvironmentAgent, edges:EnvironmentAgent):void
        {
            changed.count = 0;
            readAgent(ListedAgents.GROUND_ROW, ground);
            readAgent(ListedAgents.EDGES_ROW, edges);
            refresh();
        }

        /** Reads the surfaces of the ground and the edges again, as they are now. */
        public function refresh():void
        {
            refreshRow(ListedAgents.GROUND_ROW);
            refreshRow(ListedAgents.EDGES_ROW);
        }

        private function readAgent(row:int, agent:EnvironmentAgent):void
        {
            var agents:Vector.<Agent> = _table.listed.agentsByRow;
            if (agents[row] !== agent)
            {
                agents[row] = agent;
                _table.shapes[row] = null;
                changed.add(row);
            }
            else if (agent != null && agent.revision != _table.revisions[row])
            {
                changed.add(row);
            }
            if (agent != null)
            {
                _table.breeds[row] = agent.breedNumber;
                _table.revisions[row] = agent.revision;
            }
        }

        private function refreshRow(row:int):void
        {
            var agent:EnvironmentAgent = EnvironmentAgent(_table.listed.agentsByRow[row]);
            if (agent != null && _table.shapes[row] !== agent.surface)
            {
                _table.writeShape(row, agent.surface);
            }
        }
    }
}
