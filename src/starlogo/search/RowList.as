package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * Gives each agent of a list a row of a table. An agent keeps its row while it is listed. Free rows are used again.
     *
     * @private
     */
    public final class RowList
    {
        /** The row of the ground, the first of the fixtures, which belong to no list. The number of a fixture's breed gives its row. */
        public static const GROUND:int = 0;

        /** The row of the edges of the world. */
        public static const EDGES:int = 1;

        /** The first row for agents of a list. */
        public static const LISTED:int = 2;

        /** The rows of the agents, in the order of the list. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** The number of agents in the list; 0 after a list that was refused. */
        public var count:int = 0;

        /** A number that grows with each change of the list. While it stays the same, the rows belong to the same agents. */
        public var number:int = 0;

        /** By row: the index of its agent in the list. The ground and the edges of the world have the indices after the agents. */
        public var ranks:Vector.<int> = new <int>[0, 0];

        /** By row: the agent, or null. */
        public var agents:Vector.<Agent> = new <Agent>[null, null];

        /** The rows that the last read has added; the list may be longer than <code>addedCount</code>. */
        public var added:Vector.<int> = new Vector.<int>();

        /** The number of rows that the last read has added. */
        public var addedCount:int = 0;

        // The free rows, and their number; and the number of the list after which rows were last freed.
        private var _free:Vector.<int> = new Vector.<int>();
        private var _freeCount:int = 0;
        private var _freedNumber:int = 0;

        // By row: the number of the last list in which the agent was.
        private var _lists:Vector.<int> = new <int>[0, 0];

        private var _rowsById:IdTable = new IdTable();

        // All rows below it are in use or free.
        private var _end:int = LISTED;

        // The indices of the agents in a list that is being checked.
        private var _checked:IdTable = new IdTable();

        /** The row of an agent; -1 if it is not listed. */
        public function rowOf(agent:Agent):int
        {
            return _rowsById.valueOf(agent.number);
        }

        /** Whether the rows belong to the agents of a list, in its order. */
        public function isOf(list:Vector.<Agent>):Boolean
        {
            var i:int = 0;
            if (list.length == count)
            {
                while (i < count && agents[rows[i]] === list[i])
                {
                    i++;
                }
            }
            return i == count && list.length == count;
        }

        /**
         * Gives the agents of a list their rows. An agent that was in the last list keeps its row. An agent that is no longer in the list keeps
         * its row until <code>freeOthers()</code>.
         *
         * @throws ArgumentError as check does; no row is then added
         */
        public function read(list:Vector.<Agent>):void
        {
            var known:int = count;
            count = 0;
            addedCount = 0;
            number++;
            for (var i:int = 0; i < list.length; i++)
            {
                var agent:Agent = list[i];
                var row:int = i < known ? rows[i] : -1;
                if (row < 0 || agents[row] !== agent)
                {
                    // JavaScript callers may pass an object of any class
                    if (!(agent is Agent) || Breeds.isReserved(agent.breedNumber))
                    {
                        refuse(isNoAgent(i, agent));
                    }
                    row = rowOf(agent);
                }
                if (row < 0)
                {
                    row = add(agent);
                }
                else if (_lists[row] == number)
                {
                    refuse(listedTwice(agent, list.indexOf(agent), i));
                }
                _lists[row] = number;
                rows[i] = row;
                ranks[row] = i;
            }
            count = list.length;
            ranks[GROUND] = count;
            ranks[EDGES] = count + 1;
        }

        /**
         * Throws the errors that <code>read()</code> would throw, and changes nothing.
         *
         * @throws ArgumentError if an agent is null or listed twice
         */
        public function check(list:Vector.<Agent>):void
        {
            _checked.clear();
            for (var i:int = 0; i < list.length; i++)
            {
                var agent:Agent = list[i];
                if (!(agent is Agent) || Breeds.isReserved(agent.breedNumber))
                {
                    throw isNoAgent(i, agent);
                }
                var first:int = _checked.valueOf(agent.number);
                if (first >= 0)
                {
                    throw listedTwice(agent, first, i);
                }
                _checked.set (agent.number, i);
            }
        }

        /** Frees the rows of all agents that are not in the last list, and empties these rows in a column. */
        public function freeOthers(shapes:Vector.<ModelShape>):void
        {
            if (_freedNumber == number)
            {
                return;
            }
            _freedNumber = number;
            for (var row:int = LISTED; row < _end; row++)
            {
                if (_lists[row] != number && agents[row] != null)
                {
                    release(row);
                    shapes[row] = null;
                }
            }
        }

        private function refuse(error:Error):void
        {
            for (var i:int = 0; i < addedCount; i++)
            {
                release(added[i]);
            }
            number++;
            throw error;
        }

        private function add(agent:Agent):int
        {
            var row:int = _end;
            if (_freeCount > 0)
            {
                _freeCount--;
                row = _free[_freeCount];
            }
            else
            {
                _end++;
                // grows by an eighth, because a vector that grows by one element is copied each time
                if (_end > agents.length)
                {
                    agents.length = _lists.length = ranks.length = _end + (_end >> 3);
                }
            }
            agents[row] = agent;
            _rowsById.set (agent.number, row);
            added[addedCount] = row;
            addedCount++;
            return row;
        }

        private function release(row:int):void
        {
            _rowsById.remove(agents[row].number);
            agents[row] = null;
            _free[_freeCount] = row;
            _freeCount++;
        }

        private static function isNoAgent(index:int, agent:Agent):Error
        {
            var problem:String = agent == null ? "is null" : "must be an Agent, not " + textOf(agent, "an Agent");
            if (agent is Agent)
            {
                problem = "must be an agent of the game, not " + agent + ", which stands for the ground or the edges of the world";
            }
            return new ArgumentError("agents[" + index + "] " + problem);
        }

        private static function listedTwice(agent:Agent, first:int, second:int):Error
        {
            return new ArgumentError(agent + " is listed twice: agents[" + first + "] and agents[" + second + "]");
        }
    }
}
