package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The heights of all rows in the last update of a SeenAgents and the one before it. What is higher now has risen.
     *
     * @private
     */
    public final class SeenHeights
    {
        // In place of a revision: no agent had the row. It is less than the revision of any jump.
        private static const NO_AGENT:int = -2;

        // By row: the height from which its rise counts.
        private var _risesFrom:Vector.<Number> = new Vector.<Number>();

        // By row: the height in the last update, and the agent's revision there.
        private var _heights:Vector.<Number> = new Vector.<Number>();
        private var _revisions:Vector.<int> = new Vector.<int>();

        /** Takes the heights of all rows, as a table has read them. */
        public function read(table:AgentTable):void
        {
            var agents:Vector.<Agent> = table.listed.agentsByRow;
            var rowsBefore:int = _revisions.length;
            // locals, because the loop goes through all agents in every update
            var risesFrom:Vector.<Number> = _risesFrom;
            var heights:Vector.<Number> = _heights;
            var revisions:Vector.<int> = _revisions;
            var heightsNow:Vector.<Number> = table.places.z;
            var revisionsNow:Vector.<int> = table.revisions;
            risesFrom.length = heights.length = revisions.length = agents.length;
            for (var row:int = 0; row < agents.length; row++)
            {
                var agent:Agent = agents[row];
                risesFrom[row] = row < rowsBefore && agent != null && agent.jumpRevision <= revisions[row] ? heights[row] : heightsNow[row];
                heights[row] = heightsNow[row];
                revisions[row] = agent == null ? NO_AGENT : revisionsNow[row];
            }
        }

        /**
         * How far a one-way row of the table has risen since the update before the last one. If its agent has come or jumped between these two, it is
         * how far it has risen since the last one. It is less than 0 if it has sunk, and 0 if the agent has jumped since, and for all other rows.
         */
        public function riseOf(table:AgentTable, row:int):Number
        {
            var agent:Agent = table.listed.agentsByRow[row];
            return agent.isOneWay && agent.jumpRevision <= _revisions[row] ? table.places.z[row] - _risesFrom[row] : 0;
        }
    }
}
