package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The heights of all rows in one update of a SeenAgents. What is higher now has risen.
     *
     * @private
     */
    internal final class SeenHeights
    {
        // In place of a revision: no agent had the row. It is less than the revision of any jump.
        private static const NO_AGENT:int = -2;

        // By row: the height, and the agent's revision there.
        private var _heights:Vector.<Number> = new Vector.<Number>();
        private var _revisions:Vector.<int> = new Vector.<int>();

        /** Takes the heights of all rows, as a table has read them. */
        public function read(table:AgentTable):void
        {
            var agents:Vector.<Agent> = table.listed.agentsByRow;
            _heights.length = _revisions.length = agents.length;
            // locals, because the loop goes through all agents in every update
            var heights:Vector.<Number> = _heights;
            var revisions:Vector.<int> = _revisions;
            var heightsNow:Vector.<Number> = table.places.z;
            var revisionsNow:Vector.<int> = table.revisions;
            for (var row:int = 0; row < agents.length; row++)
            {
                heights[row] = heightsNow[row];
                revisions[row] = agents[row] == null ? NO_AGENT : revisionsNow[row];
            }
        }

        /** Whether the agent of a row of the table had the same row then, and has not jumped since. */
        public function has(table:AgentTable, row:int):Boolean
        {
            return row < _revisions.length && table.listed.agentsByRow[row].jumpRevision <= _revisions[row];
        }

        /** How far a row of the table is now above its height then. */
        public function riseOf(table:AgentTable, row:int):Number
        {
            return table.places.z[row] - _heights[row];
        }
    }
}
