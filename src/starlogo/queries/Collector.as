package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.search.KeySort;

    use namespace engine;

    /**
     * Collects the rows that answer a question: the rows with the smallest keys, as many as are wanted. A key is a distance, a squared distance
     * or a time. Rows with the same key are in the order of the list. The limit is the largest key that still counts. It shrinks when enough
     * rows are found, so the search visits less.
     *
     * <p>A search leaves out the rows that a filter excludes before it tests them. A filter's own function, <code>accepts</code>, is called
     * for rows that pass all tests, in the order of their keys, and no oftener than the answer needs. It may ask questions itself. These have
     * another Collector (QuerySet).</p>
     *
     * @private
     */
    public final class Collector
    {
        /** A value of <code>wanted</code>: all rows. */
        public static const ALL:int = int.MAX_VALUE;

        /** The number of all rows is wanted, not the rows. Only <code>end()</code> has it. */
        public static const NUMBER:int = -1;

        /** The rows that were found, unsorted. If <code>accepts</code> decides, the rows that it has admitted come first. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** The key of each row. */
        public var keys:Vector.<Number> = new Vector.<Number>();

        /** The number of rows that were found. */
        public var count:int = 0;

        /** The largest key that still counts. It is less than 0 if no more rows are wanted. */
        public var limit:Number = Infinity;

        /** The number of rows that are wanted, or ALL. */
        public var wanted:int = ALL;

        /** When this number of rows is found, <code>narrow()</code> has to be called. */
        public var narrowAt:int = ALL;

        /** Whether only the first row is wanted, and <code>accepts</code> does not decide. Then each row that is found replaces the last one. */
        public var keepsFirst:Boolean = false;

        /** Whether only the number of rows is wanted, and <code>accepts</code> does not decide. Then a search adds to <code>count</code> alone. */
        public var countsOnly:Boolean = false;

        /** The filter's <code>accepts</code>, which decides last; null if there is none. */
        public var accepts:Function = null;

        /** Whether breeds or agents are excluded. */
        public var filters:Boolean = false;

        /** The breeds that may count, a set of NodeBreeds. */
        public var breeds:int = NodeBreeds.ALL;

        /** The row of the agent that asks, which does not count; or -1. */
        public var askerRow:int = -1;

        /** The agents that questions are about. */
        public var seen:QueryWorld;

        private var _order:KeySort = new KeySort();

        // The number of rows that accepts has admitted. They come first, in order.
        private var _admitted:int = 0;

        // The number of the question, from 1 on. It marks agents by their rows, and breeds by their numbers. If the filter has breeds, the
        // marked breeds count. Else the marked breeds do not count.
        private var _question:int = 0;
        private var _excepted:Vector.<int> = new Vector.<int>();
        private var _breeds:Vector.<int> = new Vector.<int>();
        private var _breedsCount:Boolean = false;

        /** @param seen the agents that questions are about */
        public function Collector(seen:QueryWorld)
        {
            this.seen = seen;
        }

        /**
         * Begins a search.
         *
         * @param wanted how many of the rows with the smallest keys are wanted, or ALL, or NUMBER
         * @param limit the largest key
         * @param asker the agent that asks, which does not count; or null
         * @param filter the agents that count; null for all
         */
        public function begin(wanted:int, limit:Number, asker:Agent, filter:AgentFilter):void
        {
            askerRow = asker == null ? -1 : seen.table.list.rowOf(asker);
            accepts = filter == null ? null : filter.accepts;
            var asks:Boolean = accepts != null;
            mark(filter);
            countsOnly = wanted == NUMBER && !asks;
            this.wanted = wanted == NUMBER ? ALL : wanted;
            this.limit = wanted == 0 ? -1 : limit;
            keepsFirst = wanted == 1 && !asks;
            narrowAt = asks || this.wanted > ALL / 2 ? ALL : 2 * wanted;
            count = _admitted = 0;
        }

        /**
         * Whether a row counts, if it is not the one that is skipped. Ask only if <code>filters</code> is true. The filter's <code>accepts</code>
         * is not asked here.
         */
        public function admitsMarked(row:int):Boolean
        {
            return (_breeds[seen.table.list.agents[row].breedNumber] == _question) == _breedsCount && _excepted[row] != _question;
        }

        /** Whether a row counts. This is a search of its own. */
        public function admits(row:int, asker:Agent, filter:AgentFilter):Boolean
        {
            begin(1, 0, asker, filter);
            if (!filters || admitsMarked(row))
            {
                add(row, 0);
            }
            return end() > 0;
        }

        /** The next row of a search that counts and has a shape, or -1. Without a ground, the ground's row has none. */
        public function nextOf(search:SweptBoxSearch):int
        {
            var row:int = search.next(breeds);
            while (row >= 0)
            {
                if (row != askerRow && seen.table.shapes[row] != null)
                {
                    if (!filters || admitsMarked(row))
                    {
                        return row;
                    }
                    search.passOver();
                }
                row = search.next(breeds);
            }
            return -1;
        }

        /**
         * Takes a row that counts. This may lower the limit.
         *
         * @param key not greater than the limit
         * @return whether the row is among the wanted rows so far
         */
        public function add(row:int, key:Number):Boolean
        {
            if (keepsFirst)
            {
                if (count > 0 && (key > keys[0] || (key == keys[0] && seen.table.list.ranks[row] > seen.table.list.ranks[rows[0]])))
                {
                    return false;
                }
                count = 0;
                limit = key;
            }
            rows[count] = row;
            keys[count] = key;
            count++;
            if (count == narrowAt)
            {
                narrow();
            }
            return true;
        }

        /** Sorts the rows, and keeps those that are wanted. */
        public function narrow():void
        {
            _order.sort(rows, keys, count, seen.table.list.ranks);
            if (count > wanted)
            {
                count = wanted;
                limit = keys[int(wanted - 1)];
            }
        }

        /**
         * Calls <code>accepts</code> for the rows whose keys are smaller than a number, in the order of the keys, until enough are admitted. Rows
         * that are found later must have no smaller keys.
         */
        public function ask(beyond:Number):void
        {
            var end:int = beyond < Infinity ? bringForward(beyond) : count;
            if (end == _admitted)
            {
                return;
            }
            _order.sort(rows, keys, end, seen.table.list.ranks);
            var decide:Function = accepts;
            seen.asking++;
            try
            {
                for (var i:int = _admitted; i < end && _admitted < wanted; i++)
                {
                    if (decide(agentAt(i)))
                    {
                        move(i, _admitted);
                        _admitted++;
                    }
                }
            }
            finally
            {
                seen.asking--;
            }
            // accepts may have given agents new breeds
            makeRoomForBreeds();
            if (_admitted == wanted)
            {
                limit = -1;
            }
            var kept:int = _admitted;
            for (i = end; i < count; i++)
            {
                move(i, kept);
                kept++;
            }
            count = kept;
        }

        /** Ends the search. Returns how many rows are in the answer. */
        public function end():int
        {
            if (accepts != null)
            {
                ask(Infinity);
            }
            return count;
        }

        /** The agent of a row of the answer. */
        public function agentAt(index:int):Agent
        {
            return seen.table.list.agents[rows[index]];
        }

        /** Ends the search. Returns the agent of the first row of the answer, or null. */
        public function firstAgent():Agent
        {
            return end() == 0 ? null : agentAt(0);
        }

        /** Ends the search, and sorts the rows of the answer. Returns how many they are. */
        public function endSorted():int
        {
            if (accepts == null)
            {
                narrow();
            }
            return end();
        }

        /**
         * Ends the search, and lists the agents of the answer in their order.
         *
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function list(out:Vector.<Agent>):Vector.<Agent>
        {
            var listed:Vector.<Agent> = out || new Vector.<Agent>();
            var length:int = endSorted();
            // one element at a time, because V8 frees an array's memory if its length is set to less
            while (listed.length > length)
            {
                listed.pop();
            }
            for (var i:int = 0; i < length; i++)
            {
                listed[i] = agentAt(i);
            }
            return listed;
        }

        // Brings the rows whose keys are smaller than a number to the front, behind the admitted ones. Returns where they end.
        private function bringForward(beyond:Number):int
        {
            var end:int = _admitted;
            for (var i:int = end; i < count; i++)
            {
                var key:Number = keys[i];
                if (key < beyond)
                {
                    var row:int = rows[i];
                    move(end, i);
                    rows[end] = row;
                    keys[end] = key;
                    end++;
                }
            }
            return end;
        }

        private function move(from:int, to:int):void
        {
            rows[to] = rows[from];
            keys[to] = keys[from];
        }

        private function makeRoomForBreeds():void
        {
            if (_breeds.length < Breeds.count)
            {
                _breeds.length = Breeds.count;
            }
        }

        // Marks the filter's breeds and the agents that it excepts.
        private function mark(filter:AgentFilter):void
        {
            _question++;
            filters = false;
            breeds = NodeBreeds.ALL;
            if (filter == null)
            {
                return;
            }
            makeRoomForBreeds();
            if (_excepted.length < seen.table.list.agents.length)
            {
                _excepted.length = seen.table.list.agents.length;
            }
            _breedsCount = filter.breeds != null;
            filters = _breedsCount || filter.exceptBreeds != null;
            if (_breedsCount)
            {
                breeds = markBreeds(filter.breeds, _question);
            }
            if (filter.exceptBreeds != null)
            {
                var excepted:int = markBreeds(filter.exceptBreeds, _breedsCount ? 0 : _question);
                if (!_breedsCount && NodeBreeds.areSetsExact)
                {
                    breeds = ~excepted;
                }
            }
            var except:Vector.<Agent> = filter.except;
            for (var i:int = 0; except != null && i < except.length; i++)
            {
                var row:int = except[i] == null ? -1 : seen.table.list.rowOf(except[i]);
                if (row >= 0)
                {
                    filters = true;
                    _excepted[row] = _question;
                }
            }
        }

        // Marks breeds, and returns the set of them.
        private function markBreeds(names:Vector.<String>, by:int):int
        {
            var marked:int = 0;
            for (var i:int = 0; i < names.length; i++)
            {
                if (names[i] != null)
                {
                    var number:int = Breeds.numberOf(names[i]);
                    if (_breeds.length <= number)
                    {
                        _breeds.length = number + 1;
                    }
                    _breeds[number] = by;
                    marked |= NodeBreeds.setOf(number);
                }
            }
            return marked;
        }
    }
}
