package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * The places of a table's agents in one search: columns by row.
     *
     * @private
     */
    public final class RowPlaces
    {
        /** In place of a revision: the agent has no motion from its place. It is less than the revision of any jump. */
        public static const NOT_SEEN:int = -2;

        /** In place of a number of changed rows: the rows belong to other agents. */
        public static const OTHERS:int = -1;

        /** The agent's place. */
        public var x:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var y:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var z:Vector.<Number> = new Vector.<Number>();

        /** The agent's revision at that place. */
        public var revisions:Vector.<int> = new Vector.<int>();

        /** Makes this number of rows. New rows are at the origin. */
        public function grow(length:int):void
        {
            x.length = y.length = z.length = revisions.length = length;
        }

        /** Reads the place of one agent. */
        public function put(row:int, agent:Agent):void
        {
            x[row] = agent.placement.x;
            y[row] = agent.placement.y;
            z[row] = agent.placement.z;
            revisions[row] = agent.revision;
        }

        /** Whether a motion of an agent may begin at its place: the search has seen the agent there, and it has not jumped since. */
        public function isBeginning(row:int, agent:Agent):Boolean
        {
            return agent.jumpRevision <= revisions[row];
        }

        /**
         * Reads the places of agents, and lists the rows with changes in more than the place.
         *
         * @param list the agents
         * @param rows their rows
         * @param agents by row: the agent
         * @param extentsRevisions by row: the agent's revision of all but the place
         * @param changed receives the rows with such changes
         * @return the number of these rows, or OTHERS if the rows do not belong to the agents
         */
        public function read(list:Vector.<Agent>, rows:Vector.<int>, agents:Vector.<Agent>, extentsRevisions:Vector.<int>, changed:Vector.<int>):int
        {
            var readX:Vector.<Number> = x;
            var readY:Vector.<Number> = y;
            var readZ:Vector.<Number> = z;
            var read:Vector.<int> = revisions;
            var end:int = list.length;
            var found:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var agent:Agent = list[i];
                if (agents[row] !== agent)
                {
                    return OTHERS;
                }
                var placement:Placement = agent.placement;
                if (placement.extentsRevision != extentsRevisions[row])
                {
                    changed[found] = row;
                    found++;
                }
                read[row] = agent.revision;
                readX[row] = placement.x;
                readY[row] = placement.y;
                readZ[row] = placement.z;
            }
            return found;
        }
    }
}
