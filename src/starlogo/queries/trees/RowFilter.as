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
     * <code>askerRow</code> themselves. The filter's lists are read once a question. Its <code>accepts</code> is asked last, by the Collector.
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

        // Whether only the breeds of a list count.
        private var _namesBreeds:Boolean = false;

        // The number of the question, from 1 on. By row: the last question that excepted it. By the number of a breed: the last question that named
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
            _namesBreeds = filter.breeds != null;
            excludes = _namesBreeds || filter.exceptBreeds != null;
            if (excludes && _breedMarks.length < Breeds.NAMES.count)
            {
                _breedMarks.length = Breeds.NAMES.count;
            }
            if (_namesBreeds)
            {
                breedSet = markBreeds(filter.breeds, _question);
            }
            if (filter.exceptBreeds != null)
            {
                var excepted:int = markBreeds(filter.exceptBreeds, -_question);
                if (!_namesBreeds && Breeds.NAMES.count <= RowTree.BREED_BITS)
                {
                    // each breed has a bit of its own
                    breedSet = ~excepted;
                }
            }
            markExcepted(filter.except);
        }

        // Marks some breeds. Returns their set. A name may be null. No agent has an unknown breed.
        private function markBreeds(names:Vector.<String>, mark:int):int
        {
            var breeds:int = 0;
            for (var i:int = 0; i < names.length; i++)
            {
                var breed:int = names[i] == null ? -1 : Breeds.NAMES.knownNumberOf(names[i]);
                if (breed >= 0)
                {
                    breeds |= RowTree.breedBit(breed);
                    _breedMarks[breed] = mark;
                }
            }
            return breeds;
        }

        /** Whether the filter may admit a row: by its breed and the filter's <code>except</code>. <code>accepts</code> is not called. */
        public function mayAdmit(row:int):Boolean
        {
            return !excludes || (_exceptMarks[row] != _question && admitsBreed(_listed.agentsByRow[row].breedNumber));
        }

        // A filter's accepts may have made the breed since the question began.
        private function admitsBreed(breed:int):Boolean
        {
            var mark:int = breed < _breedMarks.length ? _breedMarks[breed] : 0;
            return _namesBreeds ? mark == _question : mark != -_question;
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
