package starlogo.search
{
    import starlogo.agents.Agent;

    /**
     * The pairs of agents that a search has found. Each agent is given by its index in the list that was searched.
     *
     * @private
     */
    public final class FoundPairs
    {
        private static const NONE:int = -1;

        /** The number of pairs. */
        public var count:int = 0;

        /** The indices: a0, b0, a1, b1, ... The list may be longer: numbers after the last pair are left over from earlier searches. */
        public var indices:Vector.<int> = new Vector.<int>();

        /** The number of these pairs, from 1 on. Other pairs get another number. */
        public var number:int = 0;

        /**
         * If these pairs are earlier pairs without <code>dropped</code> and with <code>added</code>: the number of the earlier pairs. Otherwise
         * NONE.
         */
        public var origin:int = NONE;

        /** The indices of the dropped pairs among the earlier ones, in ascending order. */
        public var dropped:NumberList = new NumberList();

        /** The indices of the added pairs among these pairs, in ascending order. */
        public var added:NumberList = new NumberList();

        /** The object that keeps these pairs for the next search, or null. */
        internal var keeper:Object = null;

        // The index of each agent in a list, by the agent's id.
        private var _byId:IdTable = new IdTable();

        /** Begins to write other pairs. */
        internal function begin():void
        {
            count = 0;
            number++;
            origin = NONE;
            keeper = null;
        }

        /** Reads pairs of agents: a0, b0, a1, b1, ... It leaves out a pair if one of its agents is not in the list. */
        public function read(pairs:Vector.<Agent>, list:Vector.<Agent>):void
        {
            _byId.clear();
            for (var i:int = 0; i < list.length; i++)
            {
                if (list[i] != null)
                {
                    _byId.set (list[i].id, i);
                }
            }
            begin();
            for (i = 0; i + 1 < pairs.length; i += 2)
            {
                indices[2 * count] = _byId.valueOf(pairs[i].id);
                indices[2 * count + 1] = _byId.valueOf(pairs[i + 1].id);
                if (indices[2 * count] >= 0 && indices[2 * count + 1] >= 0)
                {
                    count++;
                }
            }
        }

        /** Writes the pairs as agents: a0, b0, a1, b1, ... */
        public function write(list:Vector.<Agent>, out:Vector.<Agent>):void
        {
            for (var i:int = 0; i < 2 * count; i++)
            {
                out[i] = list[indices[i]];
            }
        }
    }
}
