package starlogo.queries
{
    import starlogo.agents.Agent;
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
        private static const NOT_SEEN:int = -1;

        private var _seen:SeenAgents;

        // The rows of one list: what follows by row is void for those of another.
        private var _table:AgentTable = null;
        private var _listNumber:int = -1;

        // By row: the number of its breed, and how many changes of the breeds of all agents there had been then; the last question that excepted it.
        private var _breeds:Vector.<int> = new Vector.<int>();
        private var _changes:Vector.<int> = new Vector.<int>();
        private var _excepted:Vector.<int> = new Vector.<int>();

        // Numbers of breeds, from 0 on; by number: the last question that was only about some breeds of which it is one, or that excepted it.
        private var _numbers:Object = {};
        private var _breedCount:int = 0;
        private var _chosen:Vector.<int> = new Vector.<int>();
        private var _refused:Vector.<int> = new Vector.<int>();

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
            followList();
            _question++;
            _choosesBreeds = filter.breeds != null;
            _refusesBreeds = filter.exceptBreeds != null;
            _excepts = filter.except != null;
            if (_choosesBreeds)
            {
                mark(filter.breeds, _chosen);
            }
            if (_refusesBreeds)
            {
                mark(filter.exceptBreeds, _refused);
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
            if (_changes[row] != Agent.breedChanges)
            {
                follow(row);
            }
            var breed:int = _breeds[row];
            return (!_choosesBreeds || _chosen[breed] == _question) && (!_refusesBreeds || _refused[breed] != _question);
        }

        private function follow(row:int):void
        {
            var agent:Agent = _table.agents[row];
            if (_changes[row] < agent.breedChange)
            {
                _breeds[row] = numberOf(agent.breed);
            }
            _changes[row] = Agent.breedChanges;
        }

        private function mark(names:Vector.<String>, marks:Vector.<int>):void
        {
            for (var i:int = 0; i < names.length; i++)
            {
                if (names[i] != null)
                {
                    marks[numberOf(names[i])] = _question;
                }
            }
        }

        private function numberOf(breed:String):int
        {
            // what begins with underscores may be a property that every object has
            var key:String = breed.charCodeAt(0) == 95 ? " " + breed : breed;
            if (!_numbers.hasOwnProperty(key))
            {
                _numbers[key] = _breedCount;
                _breedCount++;
                _chosen.length = _refused.length = _breedCount;
            }
            return _numbers[key];
        }

        private function followList():void
        {
            if (_seen.table === _table && _table.listNumber == _listNumber)
            {
                return;
            }
            _table = _seen.table;
            _listNumber = _table.listNumber;
            var length:int = _table.agents.length;
            if (_changes.length < length)
            {
                _breeds.length = _changes.length = _excepted.length = length;
            }
            for (var row:int = 0; row < length; row++)
            {
                _changes[row] = NOT_SEEN;
            }
        }
    }
}
