package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.queries.AgentFilter;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The rows of the agents that an AgentFilter admits. The agent that asks is never in its own answer; the searches leave out
     * <code>askerRow</code> themselves. The filter is asked about each breed once a question, when a row of the breed is met. Its
     * <code>accepts</code> is asked last, by the Collector.
     *
     * @private
     */
    public final class RowFilter
    {
        /** The filter's <code>accepts</code>; null if there is none. Read only, like all below. */
        public var accepts:Function = null;

        /** Whether breeds or agents are excluded. If not, <code>mayAdmit()</code> is true for all rows. */
        public var excludes:Boolean = false;

        /** The set of the breeds that the filter may admit, see RowTree. */
        public var breedSet:int = RowTree.ALL_BREEDS;

        /** The row of the agent that asks, which is left out; or -1. */
        public var askerRow:int = -1;

        private var _listed:ListedAgents;
        private var _filter:AgentFilter;

        // The number of the question, from 1 on. By row: the last question that excepted it. By the number of a breed: the last question that met
        // it, less than 0 if the filter excluded the breed.
        private var _question:int = 0;
        private var _exceptMarks:Vector.<int> = new Vector.<int>();
        private var _breedMarks:Vector.<int> = new Vector.<int>();

        /**
         * Begins a question.
         *
         * @param listed has the rows of the agents
         * @param asker the agent that asks; or null
         * @param filter the agents that count; null for all
         */
        public function begin(listed:ListedAgents, asker:Agent, filter:AgentFilter):void
        {
            _listed = listed;
            askerRow = asker == null ? -1 : _listed.rowOf(asker);
            _filter = filter;
            excludes = false;
            breedSet = RowTree.ALL_BREEDS;
            accepts = null;
            if (filter == null)
            {
                return;
            }
            filter.checkNames(_listed.agentsByRow);
            accepts = filter.accepts;
            if (_question == int.MAX_VALUE)
            {
                _exceptMarks.length = _breedMarks.length = _question = 0;
            }
            _question++;
            excludes = filter.breeds != null || filter.exceptBreeds != null;
            if (filter.breeds != null)
            {
                breedSet = setOf(filter.breeds);
            }
            else if (filter.exceptBreeds != null && Breeds.NAMES.count <= RowTree.BREED_BITS)
            {
                // each breed has a bit of its own
                breedSet = ~setOf(filter.exceptBreeds);
            }
            markExcepted(filter.except);
        }

        // The set of some breeds. A name may be null. No agent has an unknown breed.
        private static function setOf(names:Vector.<String>):int
        {
            var breeds:int = 0;
            for (var i:int = 0; i < names.length; i++)
            {
                var breed:int = names[i] == null ? -1 : Breeds.NAMES.knownNumberOf(names[i]);
                if (breed >= 0)
                {
                    breeds |= RowTree.breedBit(breed);
                }
            }
            return breeds;
        }

        /** Whether the filter may admit a row: by its breed and the filter's <code>except</code>. <code>accepts</code> is not called. */
        public function mayAdmit(row:int):Boolean
        {
            return !excludes || (_exceptMarks[row] != _question && admitsBreedOf(_listed.agentsByRow[row]));
        }

        private function admitsBreedOf(agent:Agent):Boolean
        {
            var breed:int = agent.breedNumber;
            if (breed >= _breedMarks.length)
            {
                _breedMarks.length = Breeds.NAMES.count;
            }
            var known:int = _breedMarks[breed];
            if (known == _question || known == -_question)
            {
                return known > 0;
            }
            var admits:Boolean = _filter.admitsBreed(agent.breed);
            _breedMarks[breed] = admits ? _question : -_question;
            return admits;
        }

        // Marks the rows of agents that are excepted.
        private function markExcepted(agents:Vector.<Agent>):void
        {
            if (_exceptMarks.length < _listed.rowCapacity)
            {
                _exceptMarks.length = _listed.rowCapacity;
            }
            if (agents == null)
            {
                return;
            }
            for (var i:int = 0; i < agents.length; i++)
            {
                var row:int = agents[i] == null ? -1 : _listed.rowOf(agents[i]);
                if (row >= 0)
                {
                    excludes = true;
                    _exceptMarks[row] = _question;
                }
            }
        }
    }
}
