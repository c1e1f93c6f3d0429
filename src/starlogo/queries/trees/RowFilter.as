package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.IntSet;
    import starlogo.engine;
    import starlogo.queries.AgentFilter;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * The rows of the agents that an AgentFilter admits, without the agent that asks, which is never in its own answer. The filter's lists are read once a
     * question. Its <code>accepts</code> is asked last, by the Collector.
     *
     * @private
     */
    public final class RowFilter
    {
        /** The filter's <code>accepts</code>; null if there is none. Read only, like all below. */
        public var accepts:Function = null;

        /** Whether breeds or agents are excluded. If not, <code>mayAdmit()</code> is true for all rows but the asker's. */
        public var excludes:Boolean = false;

        /** The set of the breeds that the filter may admit, see RowTree. */
        public var breedSet:int = RowTree.ALL_BREEDS;

        /** The row of the agent that asks, which is left out; or -1. */
        public var askerRow:int = -1;

        private var _listed:ListedAgents;

        // The numbers of the breeds that the filter names; and whether only these may count, or all but these.
        private var _namedBreeds:IntSet = new IntSet();
        private var _onlyNamed:Boolean = false;

        private var _exceptRows:IntSet = new IntSet();

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
            excludes = filter.breeds != null || filter.exceptBreeds != null || filter.except != null;
            _onlyNamed = filter.breeds != null;
            if (_onlyNamed)
            {
                breedSet = readBreeds(filter.breeds, filter.exceptBreeds);
            }
            else
            {
                var excepted:int = readBreeds(filter.exceptBreeds, null);
                // if each breed has a bit of its own
                breedSet = Breeds.NAMES.count <= RowTree.BREED_BITS ? ~excepted : RowTree.ALL_BREEDS;
            }
            readExcept(filter.except);
        }

        // Reads the numbers of breeds, without those of a second list. Both lists may be null, and so may a name. No agent has an unknown breed. Returns the
        // breeds' set for a RowTree.
        private function readBreeds(names:Vector.<String>, without:Vector.<String>):int
        {
            var breeds:int = 0;
            _namedBreeds.clear(Breeds.NAMES.count);
            for (var i:int = 0; names != null && i < names.length; i++)
            {
                var breed:int = names[i] == null ? -1 : Breeds.NAMES.knownNumberOf(names[i]);
                if (breed >= 0 && (without == null || without.indexOf(names[i]) < 0))
                {
                    breeds |= RowTree.breedBit(breed);
                    _namedBreeds.add(breed);
                }
            }
            return breeds;
        }

        // Reads the rows of agents that are excepted.
        private function readExcept(agents:Vector.<Agent>):void
        {
            _exceptRows.clear(_listed.rowCapacity);
            for (var i:int = 0; agents != null && i < agents.length; i++)
            {
                var row:int = agents[i] == null ? -1 : _listed.rowOf(agents[i]);
                if (row >= 0)
                {
                    _exceptRows.add(row);
                }
            }
        }

        /** Whether a row may count: by its agent, its breed and the filter's <code>except</code>. <code>accepts</code> is not called. */
        public function mayAdmit(row:int):Boolean
        {
            return row != askerRow && (!excludes || (!_exceptRows.has(row) && admitsBreed(_listed.agentsByRow[row].breedNumber)));
        }

        private function admitsBreed(breed:int):Boolean
        {
            // a filter's accepts may have made a breed since the question began
            return (breed < _namedBreeds.marks.length && _namedBreeds.has(breed)) == _onlyNamed;
        }
    }
}
