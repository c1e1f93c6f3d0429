package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Points;
    import starlogo.engine;

    use namespace engine;

    /**
     * The places of a table's agents in one search: columns by row.
     *
     * @private
     */
    public final class RowPlaces extends Points
    {
        // In place of a revision: no motion begins at the place. It is less than the revision of any jump.
        private static const NOT_SEEN:int = -2;

        /** The agent's revision at that place. */
        public var revisions:Vector.<int> = new Vector.<int>();

        /** @inheritDoc */
        override public function grow(length:int):void
        {
            super.grow(length);
            revisions.length = length;
        }

        /** Reads the place of one agent. */
        public function read(row:int, agent:Agent):void
        {
            x[row] = agent.placement.x;
            y[row] = agent.placement.y;
            z[row] = agent.placement.z;
            revisions[row] = agent.revision;
        }

        /** Whether a motion of an agent may begin at its place: the search has seen the agent there, and it has not jumped since. */
        public function isMotionStart(row:int, agent:Agent):Boolean
        {
            return agent.jumpRevision <= revisions[row];
        }

        /** Lets no motion of a row's agent begin at its place. */
        public function forget(row:int):void
        {
            revisions[row] = NOT_SEEN;
        }

        /** Lets no motion of any agent begin at its place. */
        public function forgetAll():void
        {
            for (var row:int = 0; row < revisions.length; row++)
            {
                forget(row);
            }
        }

        /** Takes the place of one row from other places. */
        public function copyRow(from:RowPlaces, row:int):void
        {
            x[row] = from.x[row];
            y[row] = from.y[row];
            z[row] = from.z[row];
            revisions[row] = from.revisions[row];
        }
    }
}
