package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * Tests rows by a filter's breeds and exceptions, without calling <code>accepts</code>. For each question it marks the breeds by their
     * numbers, and the excepted agents by their rows.
     *
     * @private
     */
    public final class FilteredRows
    {
        private var _seen:SeenAgents;
        private var _agents:Vector.<Agent>;

        // By row: the number of the last question that excepted the row's agent.
        private var _excepted:Vector.<int> = new Vector.<int>();

        // By the breed's number: the number of the last question that marked the breed, or 0.
        private var _marks:Vector.<int> = new Vector.<int>();

        // The number of the question, from 1 on. If a filter has breeds, the marked breeds count. Else the marked breeds do not count.
        private var _question:int = 0;
        private var _marksChosen:Boolean = false;
        private var _excepts:Boolean = false;

        /** @param seen the agents that questions are about */
        public function FilteredRows(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Prepares this test for a filter, in place of the last one.
         *
         * @param filter not null
         * @return this test, or null if all rows count
         */
        public function of(filter:AgentFilter):FilteredRows
        {
            if (filter.breeds == null && filter.exceptBreeds == null && filter.except == null)
            {
                return null;
            }
            _agents = _seen.table.agents;
            _question++;
            _marksChosen = filter.breeds != null;
            if (_marksChosen)
            {
                mark(filter.breeds, _question);
            }
            if (filter.exceptBreeds != null)
            {
                mark(filter.exceptBreeds, _marksChosen ? 0 : _question);
            }
            makeRoom();
            if (_excepted.length < _agents.length)
            {
                _excepted.length = _agents.length;
            }
            var except:Vector.<Agent> = filter.except;
            _excepts = except != null;
            for (var i:int = 0; _excepts && i < except.length; i++)
            {
                var row:int = except[i] == null ? -1 : _seen.table.rowOf(except[i]);
                if (row >= 0)
                {
                    _excepted[row] = _question;
                }
            }
            return this;
        }

        /** Whether a row counts. */
        public function accepts(row:int):Boolean
        {
            if (_excepts && _excepted[row] == _question)
            {
                return false;
            }
            return _marks[_agents[row].breedNumber] == _question ? _marksChosen : !_marksChosen;
        }

        private function mark(names:Vector.<String>, by:int):void
        {
            for (var i:int = 0; i < names.length; i++)
            {
                if (names[i] != null)
                {
                    var number:int = Breeds.numberOf(names[i]);
                    makeRoom();
                    _marks[number] = by;
                }
            }
        }

        private function makeRoom():void
        {
            if (_marks.length < Breeds.count)
            {
                _marks.length = Breeds.count;
            }
        }
    }
}
