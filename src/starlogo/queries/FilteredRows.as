package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * A filter but for <code>accepts</code>, made ready for one question: breeds are compared as numbers, and the agents that are excepted
     * are marked.
     *
     * @private
     */
    public final class FilteredRows extends RowTest
    {
        private var _seen:SeenAgents;
        private var _table:AgentTable = null;

        // By row: the last question that excepted its agent.
        private var _excepted:Vector.<int> = new Vector.<int>();

        // By the number of a breed: the last question that chose it, and the last that refused it.
        private var _chosen:Vector.<int> = new Vector.<int>();
        private var _refused:Vector.<int> = new Vector.<int>();

        // The names that filters had, in their order, and their numbers: to look a name up makes a text for its key.
        private var _names:Vector.<String> = new Vector.<String>();
        private var _numbers:Vector.<int> = new Vector.<int>();
        private var _nameCount:int = 0;

        // The question's number, and what it has to look at.
        private var _question:int = 0;
        private var _choosesBreeds:Boolean = false;
        private var _refusesBreeds:Boolean = false;
        private var _excepts:Boolean = false;

        /** @param seen the agents that are asked about */
        public function FilteredRows(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Makes a filter ready; the one before is not any more.
         *
         * @param filter null for all agents
         * @return this test; null if all rows count
         */
        public function of(filter:AgentFilter):RowTest
        {
            if (filter == null || (filter.breeds == null && filter.exceptBreeds == null && filter.except == null))
            {
                return null;
            }
            _table = _seen.table;
            _question++;
            _choosesBreeds = filter.breeds != null;
            _refusesBreeds = filter.exceptBreeds != null;
            _excepts = filter.except != null;
            _nameCount = 0;
            if (_choosesBreeds)
            {
                mark(filter.breeds, _chosen);
            }
            if (_refusesBreeds)
            {
                mark(filter.exceptBreeds, _refused);
            }
            makeRoom();
            if (_excepted.length < _table.agents.length)
            {
                _excepted.length = _table.agents.length;
            }
            var except:Vector.<Agent> = filter.except;
            for (var i:int = 0; _excepts && i < except.length; i++)
            {
                var row:int = except[i] == null ? -1 : _table.rowOf(except[i]);
                if (row >= 0)
                {
                    _excepted[row] = _question;
                }
            }
            return this;
        }

        /** @inheritDoc */
        override public function accepts(row:int):Boolean
        {
            if (_excepts && _excepted[row] == _question)
            {
                return false;
            }
            if (!_choosesBreeds && !_refusesBreeds)
            {
                return true;
            }
            var breed:int = _table.agents[row].breedNumber;
            return (!_choosesBreeds || _chosen[breed] == _question) && (!_refusesBreeds || _refused[breed] != _question);
        }

        private function mark(names:Vector.<String>, marks:Vector.<int>):void
        {
            for (var i:int = 0; i < names.length; i++)
            {
                if (names[i] != null)
                {
                    var number:int = numberOf(names[i]);
                    makeRoom();
                    marks[number] = _question;
                }
            }
        }

        private function makeRoom():void
        {
            if (_chosen.length < Breeds.count)
            {
                _chosen.length = _refused.length = Breeds.count;
            }
        }

        private function numberOf(name:String):int
        {
            var at:int = _nameCount;
            _nameCount++;
            if (at == _names.length || _names[at] != name)
            {
                _names[at] = name;
                _numbers[at] = Breeds.numberOf(name);
            }
            return _numbers[at];
        }
    }
}
