package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.agents.Breeds;
    import starlogo.agents.copyAgents;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The input of a search: the list of agents, which of them take part, which breeds count, the ground and the edges of the world. The rows of a
     * table that a search tests are called its members. The input decides which they are.
     *
     * @private
     */
    public final class SearchInput
    {
        /** The list of agents. If there is a filter it is a copy, because a filter may change the game's list. Read only. */
        public var agents:Vector.<Agent> = null;

        /** By index in the list: whether the filter admits the agent; null without a filter. Read only. */
        public var admitted:Vector.<Boolean> = null;

        /** The pairs of breeds that count. Read only. */
        public var interests:BreedInterests = null;

        /** The ground, or null. Read only. */
        public var ground:EnvironmentAgent = null;

        /** The edges of the world, or null. Read only. */
        public var edges:EnvironmentAgent = null;

        // The copy of the list, if there is a filter.
        private var _copy:Vector.<Agent> = new Vector.<Agent>();

        // The answers of a filter, by index in the list.
        private var _answers:Vector.<Boolean> = new Vector.<Boolean>();

        // The members among some rows.
        private var _members:IntList = new IntList();

        /**
         * Begins a search: takes its input, and asks the filter.
         *
         * @param agents the list of agents
         * @param interests the pairs of breeds that count
         * @param ground the ground, or null
         * @param edges the edges of the world, or null
         * @param filter is asked which agents take part; null if all do
         * @throws Error what the filter throws
         */
        public function begin(agents:Vector.<Agent>, interests:BreedInterests, ground:EnvironmentAgent, edges:EnvironmentAgent, filter:AgentPredicate):void
        {
            this.agents = agents;
            this.interests = interests;
            this.ground = ground;
            this.edges = edges;
            admitted = null;
            if (filter != null)
            {
                askFilter(filter);
            }
        }

        /** The agents that the filter admits: a new list if there is a filter. */
        public function get admittedAgents():Vector.<Agent>
        {
            return admitted == null ? agents : agents.filter(function(agent:Agent, index:int, ...ignored):Boolean
                {
                    return admitted[index];
                });
        }

        /**
         * Becomes a search of a frame's whole list, with its filter, if this one's list has just the agents that the filter admits. So the others keep
         * their motions.
         */
        public function takeFilterOf(frame:SearchInput):void
        {
            var admittedOfFrame:Vector.<Agent> = frame.admittedAgents;
            var areSame:Boolean = agents.length == admittedOfFrame.length;
            for (var i:int = 0; areSame && i < agents.length; i++)
            {
                areSame = agents[i] === admittedOfFrame[i];
            }
            if (areSame)
            {
                agents = frame.agents;
                admitted = frame.admitted;
            }
        }

        /** The members of the search among all rows of a table, until the next call of this method or of <code>membersAmong()</code>. */
        public function membersOf(table:AgentTable):IntList
        {
            var areAllMembers:Boolean = table.loadingCount == 0 && admitted == null && interests.isNamed(Breeds.ANY_NUMBER);
            return areAllMembers ? table.listed.rows : membersAmong(table.listed.rows, table);
        }

        /** The members among some rows of a table: a list that the caller may change, until the next call. */
        public function membersAmong(rows:IntList, table:AgentTable):IntList
        {
            _members.count = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                if (isMember(rows.values[i], table))
                {
                    _members.add(rows.values[i]);
                }
            }
            return _members;
        }

        /**
         * Whether a row of a table is a member of the search: it has a shape, its breed is of interest, and its agent takes part. Those of the ground and
         * the edges of the world are none.
         */
        public function isMember(row:int, table:AgentTable):Boolean
        {
            return row >= ListedAgents.FIRST_LISTED && table.shapes[row] != null && interests.matchingBreedOf(table.breeds[row]) >= 0
                && (admitted == null || admitted[table.listed.listIndices[row]]);
        }

        // Asks a filter which agents take part. An entry that is null does, because the collision system refuses it.
        private function askFilter(filter:AgentPredicate):void
        {
            agents = copyAgents(agents, _copy);
            admitted = _answers;
            filter.checkNames(agents);
            for (var i:int = 0; i < agents.length; i++)
            {
                // in JavaScript a filter may answer with any value
                admitted[i] = agents[i] == null || Boolean(filter.admits(agents[i]));
            }
        }
    }
}
