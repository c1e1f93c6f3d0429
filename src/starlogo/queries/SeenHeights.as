package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * How high the last two updates of a SeenAgents have seen its agents. What is higher now has risen.
     *
     * @private
     */
    internal final class SeenHeights
    {
        // In place of a revision: no agent had the row. It is less than the revision of any jump.
        private static const NO_AGENT:int = -2;

        // By row: the height in the last update, and the agent's revision there.
        private var _heights:Vector.<Number> = new Vector.<Number>();
        private var _revisions:Vector.<int> = new Vector.<int>();

        // By row: the height in the update before. That of the last update, if the agent was not listed before or has jumped between the two.
        private var _heightsBefore:Vector.<Number> = new Vector.<Number>();

        /** Takes the heights of all rows, as a table has read them in an update. */
        public function update(table:AgentTable):void
        {
            var agents:Vector.<Agent> = table.listed.agentsByRow;
            while (_revisions.length < agents.length)
            {
                _revisions.push(NO_AGENT);
            }
            _heights.length = _heightsBefore.length = agents.length;
            // locals, because the loop goes through all agents in every update
            var heights:Vector.<Number> = _heights;
            var before:Vector.<Number> = _heightsBefore;
            var revisions:Vector.<int> = _revisions;
            var heightsNow:Vector.<Number> = table.places.z;
            var revisionsNow:Vector.<int> = table.revisions;
            for (var row:int = 0; row < agents.length; row++)
            {
                var agent:Agent = agents[row];
                if (agent == null)
                {
                    revisions[row] = NO_AGENT;
                    continue;
                }
                before[row] = agent.jumpRevision <= revisions[row] ? heights[row] : heightsNow[row];
                heights[row] = heightsNow[row];
                revisions[row] = revisionsNow[row];
            }
        }

        /**
         * How far a one-way row of the table is now above its height in the update before the last one. Less than 0 if below; 0 after a jump, and of
         * other rows.
         */
        public function riseOf(table:AgentTable, row:int):Number
        {
            var agent:Agent = table.listed.agentsByRow[row];
            return agent.isOneWay && agent.jumpRevision <= _revisions[row] ? table.places.z[row] - _heightsBefore[row] : 0;
        }
    }
}
