package starlogo.models
{
    /**
     * The loads of a ModelLoader that are not over, in the order in which they were added. A load is found by its name, added and removed in
     * constant time, because a game may have thousands. The loads are linked with each other, and those of one name once more.
     */
    internal final class LoadQueue
    {
        // stands before every key, because a model may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        private var _first:ModelLoad = null;
        private var _last:ModelLoad = null;
        private var _count:int = 0;

        // By name: the load of this name that was added last.
        private var _newest:Object = {};

        /** The load that was added first, or null. The others follow as <code>next</code>. */
        public function get first():ModelLoad
        {
            return _first;
        }

        /** The number of loads. */
        public function get count():int
        {
            return _count;
        }

        /** Whether it has a load of this name. */
        public function has(name:String):Boolean
        {
            return newest(name) != null;
        }

        /** The load of this name that was added last, or null. */
        public function newest(name:String):ModelLoad
        {
            return _newest[PREFIX + name];
        }

        /** Returns a list of the loads of a name, or of all if the name is null. The load that was added last comes first. */
        public function newestFirst(name:String):Vector.<ModelLoad>
        {
            var found:Vector.<ModelLoad> = new Vector.<ModelLoad>();
            var load:ModelLoad = name == null ? _last : newest(name);
            while (load != null)
            {
                found.push(load);
                load = name == null ? load.previous : load.olderNamesake;
            }
            return found;
        }

        /** Adds a load at the end. It must not be in any queue. */
        public function add(load:ModelLoad):void
        {
            load.previous = _last;
            if (_last == null)
            {
                _first = load;
            }
            else
            {
                _last.next = load;
            }
            _last = load;
            var older:ModelLoad = newest(load.name);
            load.olderNamesake = older;
            if (older != null)
            {
                older.newerNamesake = load;
            }
            _newest[PREFIX + load.name] = load;
            _count++;
        }

        /** Removes a load. Returns false if it is not in the queue. */
        public function remove(load:ModelLoad):Boolean
        {
            if (load !== _first && load.previous == null)
            {
                return false;
            }
            unlink(load);
            unlinkNamesake(load);
            load.previous = load.next = load.olderNamesake = load.newerNamesake = null;
            _count--;
            return true;
        }

        private function unlink(load:ModelLoad):void
        {
            if (load.previous == null)
            {
                _first = load.next;
            }
            else
            {
                load.previous.next = load.next;
            }
            if (load.next == null)
            {
                _last = load.previous;
            }
            else
            {
                load.next.previous = load.previous;
            }
        }

        private function unlinkNamesake(load:ModelLoad):void
        {
            if (load.olderNamesake != null)
            {
                load.olderNamesake.newerNamesake = load.newerNamesake;
            }
            if (load.newerNamesake != null)
            {
                load.newerNamesake.olderNamesake = load.olderNamesake;
            }
            else if (load.olderNamesake != null)
            {
                _newest[PREFIX + load.name] = load.olderNamesake;
            }
            else
            {
                delete _newest[PREFIX + load.name];
            }
        }
    }
}
