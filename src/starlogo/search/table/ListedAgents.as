package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.data.IntPairMap;
    import starlogo.data.IntSet;
    import starlogo.data.textOf;
    import starlogo.data.warnOfUnknownProperties;
    import starlogo.engine;

    use namespace engine;

    /**
     * The list of a table, and the row of each of its agents. An agent keeps its row while it is listed. Free rows are used again.
     *
     * <p>A new list is first proposed and then accepted. Until it is accepted, the agents of the list before are the ones that are listed.</p>
     *
     * @private
     */
    public final class ListedAgents
    {
        /** The row of the agent of the ground, which is given beside the list. */
        public static const GROUND_ROW:int = 0;

        /** The row of the agent of the edges of the world, which is given beside the list too. */
        public static const EDGES_ROW:int = 1;

        /** The first row for agents of a list. */
        public static const FIRST_LISTED:int = 2;

        // The order key of the oldest agent that has no row. It is more than the number of agents in any list.
        private static const FIRST_UNLISTED_KEY:int = 1 << 30;

        /** The rows of the agents, in the order of the list. */
        public var rows:IntList = new IntList();

        /** By row: the index of its agent in the list. The ground and the edges of the world have the indices after the agents. */
        public var listIndices:Vector.<int> = new <int>[0, 1];

        /** The agent of each row, or null. */
        public var agentsByRow:Vector.<Agent> = new <Agent>[null, null];

        /**
         * The rows whose agents are missing from the list that was accepted last, or have another place in it than in the one before. The agents of
         * all other rows have the same order in both. The table empties it if the list is the same again.
         */
        public var leftOrReordered:IntList = new IntList();

        /** The rows of the agents of the proposed list, in its order. The rows of new agents are free until it is accepted. */
        internal var proposed:IntList = new IntList();

        private var _free:IntList = new IntList();
        private var _inOrder:Vector.<int> = new Vector.<int>();
        private var _rowsById:IntPairMap = new IntPairMap();

        // The rows of the proposed list, and the ids of its new agents.
        private var _inProposed:IntSet = new IntSet();
        private var _newIds:IntPairMap = new IntPairMap();

        /** The number of rows that there are, free ones too. It never shrinks. */
        public function get rowCapacity():int
        {
            return agentsByRow.length;
        }

        /** The row of an agent; -1 if it is not listed. The ground and the edges of the world have their rows from the last search on. */
        public function rowOf(agent:Agent):int
        {
            if (agent.isEnvironment)
            {
                return agentsByRow[GROUND_ROW] === agent ? GROUND_ROW : agentsByRow[EDGES_ROW] === agent ? EDGES_ROW : -1;
            }
            return _rowsById.find(agent.idNumber, 0);
        }

        /**
         * Says where an agent comes in the order of tests: its index in the list. Agents that are not listed come after these, the older ones
         * first. The ground and the edges of the world come last. In <code>listIndices</code> they come right after the list.
         *
         * @param row the answer of <code>rowOf()</code>
         */
        public function orderKeyOf(agent:Agent, row:int):int
        {
            if (agent.isEnvironment)
            {
                return int.MAX_VALUE;
            }
            return row >= 0 ? listIndices[row] : FIRST_UNLISTED_KEY + agent.idNumber;
        }

        /** Whether the rows belong to the agents of a list, in its order. */
        public function isListed(list:Vector.<Agent>):Boolean
        {
            var listed:Vector.<int> = rows.values;
            var byRow:Vector.<Agent> = agentsByRow;
            var isSame:Boolean = list.length == rows.count;
            for (var i:int = 0; isSame && i < list.length; i++)
            {
                isSame = byRow[listed[i]] === list[i];
            }
            return isSame;
        }

        /**
         * Finds the rows that the agents of a list have, and free ones for new agents. Call it alone to find out whether a list is refused.
         *
         * @throws ArgumentError if an agent is null or listed twice
         */
        public function propose(list:Vector.<Agent>):void
        {
            var listed:Vector.<int> = rows.values;
            var to:Vector.<int> = proposed.values;
            var newCount:int = 0;
            _inProposed.clear(rowCapacity);
            _newIds.clear();
            for (var i:int = 0; i < list.length; i++)
            {
                var agent:Agent = list[i];
                var row:int = i < rows.count ? listed[i] : -1;
                if (row < 0 || agentsByRow[row] !== agent)
                {
                    requireAgent(i, agent);
                    row = _rowsById.find(agent.idNumber, 0);
                }
                if (row < 0 ? _newIds.set (agent.idNumber, 0, i) >= 0 : !_inProposed.add(row))
                {
                    throw listedTwiceError(list, i);
                }
                newCount += int(row < 0);
                to[i] = row;
            }
            proposed.count = list.length;
            if (newCount > 0)
            {
                chooseFreeRows(newCount);
            }
        }

        // Chooses the rows of the new agents of the proposed list: the last free ones. They stay free.
        private function chooseFreeRows(newCount:int):void
        {
            if (newCount > _free.count)
            {
                addRows(newCount - _free.count);
            }
            var next:int = _free.count;
            for (var i:int = 0; i < proposed.count; i++)
            {
                if (proposed.values[i] < 0)
                {
                    next--;
                    proposed.values[i] = _free.values[next];
                }
            }
        }

        private function addRows(count:int):void
        {
            var before:int = rowCapacity;
            // and an eighth more, because a vector that grows a little each time is copied each time
            agentsByRow.length = listIndices.length = before + count + (before >> 3);
            for (var row:int = rowCapacity - 1; row >= before; row--)
            {
                _free.add(row);
            }
        }

        /**
         * Makes the agents of the proposed list the ones that are listed. New agents take their rows, and the rows of those that have left become free.
         *
         * @param list the list that was proposed
         */
        public function accept(list:Vector.<Agent>):void
        {
            findReordered(leftOrReordered);
            var before:IntList = rows;
            rows = proposed;
            proposed = before;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.values[i];
                if (agentsByRow[row] == null)
                {
                    take(row, list[i]);
                }
                listIndices[row] = i;
            }
            // only now, because the new agents take the last free rows
            for (i = 0; i < before.count; i++)
            {
                row = before.values[i];
                if (!_inProposed.has(row))
                {
                    leftOrReordered.add(row);
                    free(row);
                }
            }
            listIndices[GROUND_ROW] = rows.count;
            listIndices[EDGES_ROW] = rows.count + 1;
        }

        // The two have the same id. In JavaScript they may be two agents: Object.assign copies it.
        private static function listedTwiceError(list:Vector.<Agent>, index:int):ArgumentError
        {
            var agent:Agent = list[index];
            var first:int = 0;
            while (list[first].idNumber != agent.idNumber)
            {
                first++;
            }
            var why:String = list[first] === agent ? "" : ", a copy";
            return new ArgumentError(agent + " is listed twice: agents[" + first + "] and agents[" + index + "]" + why);
        }

        /**
         * Throws an ArgumentError if an object is not an agent of the game.
         *
         * @param index its index in a list
         * @param agent JavaScript callers may pass an object of any class
         */
        public static function requireAgent(index:int, agent:Agent):void
        {
            if (!(agent is Agent))
            {
                throw new ArgumentError("agents[" + index + "] " + (agent === null ? "is null" : "must be an Agent, not " + textOf(agent, "an Agent")));
            }
            if (agent.isEnvironment)
            {
                throw new ArgumentError("agents[" + index + "] must be an agent of the game, not " + agent
                        + ", which stands for the ground or the edges of the world");
            }
        }

        // Gives the last free row to a new agent.
        private function take(row:int, agent:Agent):void
        {
            warnOfUnknownProperties(agent);
            _free.count--;
            agentsByRow[row] = agent;
            _rowsById.set (agent.idNumber, 0, row);
        }

        private function free(row:int):void
        {
            _rowsById.remove(agentsByRow[row].idNumber, 0);
            agentsByRow[row] = null;
            _free.add(row);
        }

        // Finds rows so that all others have the same order in both lists. If the last agent took the place of one that was removed, it is one row.
        private function findReordered(out:IntList):void
        {
            out.count = 0;
            var inOrder:Vector.<int> = _inOrder;
            var end:int = 0;
            for (var i:int = 0; i < proposed.count; i++)
            {
                var row:int = proposed.values[i];
                if (agentsByRow[row] == null)
                {
                    continue;
                }
                var index:int = listIndices[row];
                if (end > 0 && listIndices[inOrder[int(end - 1)]] > index)
                {
                    if (end > 1 && listIndices[inOrder[int(end - 2)]] > index)
                    {
                        out.add(row);
                        continue;
                    }
                    end--;
                    out.add(inOrder[end]);
                }
                inOrder[end] = row;
                end++;
            }
        }
    }
}
