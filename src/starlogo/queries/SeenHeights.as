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
            for (var row:int = 0; row < agents.length; row++)
            {
                if (agents[row] == null)
                {
                    _revisions[row] = NO_AGENT;
                    continue;
                }
                var height:Number = table.places.z[row];
                _heightsBefore[row] = agents[row].jumpRevision <= _revisions[row] ? _heights[row] : height;
                _heights[row] = height;
                _revisions[row] = table.revisions[row];
            }
        }

        /** How far a row of the table is now above its height in the update before the last one. Less than 0 if below; 0 after a jump. */
        public function riseOf(table:AgentTable, row:int):Number
        {
            return table.listed.agentsByRow[row].jumpRevision <= _revisions[row] ? table.places.z[row] - _heightsBefore[row] : 0;
        }
    }
}
