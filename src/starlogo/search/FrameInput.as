package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The input of a frame's search: the list of agents, which of them take part, which breeds count, the ground and the edges of the world.
     *
     * @private
     */
    public final class FrameInput
    {
        /** The list of agents. If there is a filter it is a copy, because a filter may change the game's list. */
        public var agents:Vector.<Agent> = null;

        /** By index in the list: whether the filter admits the agent; null without a filter. */
        public var admitted:Vector.<Boolean> = null;

        /** The pairs of breeds that count; null for all. It must not be null if there is ground or there are edges. */
        public var interests:BreedInterests = null;

        /** The ground, or null. */
        public var ground:WorldAgent = null;

        /** The edges of the world, or null. */
        public var edges:WorldAgent = null;

        // What a filter fills: the copy of the list, and its answers.
        private var _copy:Vector.<Agent> = new Vector.<Agent>();
        private var _answers:Vector.<Boolean> = new Vector.<Boolean>();

        /** Sets all. All agents take part. */
        public function setTo(agents:Vector.<Agent>, interests:BreedInterests, ground:WorldAgent, edges:WorldAgent):void
        {
            this.agents = agents;
            this.interests = interests;
            this.ground = ground;
            this.edges = edges;
            admitted = null;
        }

        /** Asks a filter of the game's which agents take part. An entry that is null does, because the collision system refuses it. */
        public function askFilter(filter:AgentPredicate):void
        {
            copyList(agents, _copy);
            agents = _copy;
            admitted = _answers;
            filter.checkNames(agents);
            for (var i:int = 0; i < agents.length; i++)
            {
                admitted[i] = agents[i] == null || filter.admits(agents[i]);
            }
        }

        /** Whether an agent of the list sweeps. No entry of the list is null. */
        public function isAnySweeping():Boolean
        {
            var i:int = Agent.haveSwept ? agents.length - 1 : -1;
            while (i >= 0 && !agents[i].isSweeping)
            {
                i--;
            }
            return i >= 0;
        }

        /** Whether a row is a member of the search: it has a shape, its breed is of interest, and its agent takes part. */
        public function isMember(table:AgentTable, row:int):Boolean
        {
            return table.shapes[row] != null && (interests == null || interests.representativeOf(table.breeds[row]) >= 0)
                && (admitted == null || admitted[table.list.ranks[row]]);
        }

        /** Lists the members among some rows. @param out receives them */
        public function listMembers(table:AgentTable, rows:IntList, out:IntList):void
        {
            out.count = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                if (isMember(table, rows.numbers[i]))
                {
                    out.add(rows.numbers[i]);
                }
            }
        }

        /** Makes a list a copy of another. */
        public static function copyList(from:Vector.<Agent>, to:Vector.<Agent>):void
        {
            to.length = from.length;
            for (var i:int = 0; i < from.length; i++)
            {
                // writing a reference costs more than comparing it
                if (to[i] !== from[i])
                {
                    to[i] = from[i];
                }
            }
        }
    }
}
