package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * Remembers from frame to frame who touches whom. A table of lists by the agents' ids, and one list of all in the order in which they
     * began. Records are used again: a frame in which nothing begins allocates nothing, and memory goes with the pairs
     * that touch.
     */
    internal final class TouchTracker
    {
        private static const FEWEST:int = 16;

        /** Counts the frames. */
        public var frame:int = 0;

        /** The touches that the last frame did not see any more, in the order in which they began. */
        public var ended:Vector.<TouchRecord> = new Vector.<TouchRecord>();

        private var _lists:Vector.<TouchRecord> = new Vector.<TouchRecord>(FEWEST);
        private var _count:int = 0;
        private var _oldest:TouchRecord = null;
        private var _newest:TouchRecord = null;
        private var _spare:TouchRecord = null;
        private var _spareCount:int = 0;

        /** Nobody touches anybody. */
        public function TouchTracker()
        {
        }

        /** How many touch. */
        public function get count():int
        {
            return _count;
        }

        /** The touch of two agents, in either order, or null. */
        public function find(a:Agent, b:Agent):TouchRecord
        {
            var touch:TouchRecord = _lists[placeOf(a, b)];
            while (touch != null)
            {
                if (touch.first === a && touch.second === b || touch.first === b && touch.second === a)
                {
                    return touch;
                }
                touch = touch.next;
            }
            return null;
        }

        /** Adds a touch of two agents that have none. */
        public function add(first:Agent, second:Agent):TouchRecord
        {
            if (_count >= _lists.length)
            {
                resize(2 * _lists.length);
            }
            var touch:TouchRecord = _spare;
            if (touch == null)
            {
                touch = new TouchRecord();
            }
            else
            {
                _spare = touch.next;
                _spareCount--;
            }
            touch.first = first;
            touch.second = second;
            touch.firstBreed = first.breed;
            touch.secondBreed = second.breed;
            touch.beganIn = touch.seenIn = frame;
            touch.known = 0;
            touch.breedToken = null;
            enter(touch);
            touch.older = _newest;
            touch.newer = null;
            if (_newest == null)
            {
                _oldest = touch;
            }
            else
            {
                _newest.newer = touch;
            }
            _newest = touch;
            _count++;
            return touch;
        }

        /** Takes out those that this frame did not see, into <code>ended</code>. */
        public function takeEnded():void
        {
            ended.length = 0;
            var touch:TouchRecord = _oldest;
            while (touch != null)
            {
                var newer:TouchRecord = touch.newer;
                if (touch.seenIn != frame)
                {
                    remove(touch);
                    ended.push(touch);
                }
                touch = newer;
            }
            if (_lists.length > FEWEST && 8 * _count < _lists.length)
            {
                resize(Math.max(FEWEST, _lists.length / 4));
            }
        }

        /** Lets go of those that have ended. */
        public function forgetEnded():void
        {
            for (var i:int = 0; i < ended.length; i++)
            {
                var touch:TouchRecord = ended[i];
                touch.first = touch.second = null;
                touch.breedToken = null;
                if (_spareCount < _count + FEWEST)
                {
                    touch.next = _spare;
                    _spare = touch;
                    _spareCount++;
                }
            }
            ended.length = 0;
            while (_spareCount > _count + FEWEST)
            {
                _spare = _spare.next;
                _spareCount--;
            }
        }

        private function placeOf(a:Agent, b:Agent):int
        {
            // the same in either order, and without a product, which is a Number
            var mixed:int = a.id ^ b.id;
            var sum:int = a.id + b.id;
            return (mixed ^ (sum << 5) ^ (sum << 1)) & (_lists.length - 1);
        }

        private function enter(touch:TouchRecord):void
        {
            var place:int = placeOf(touch.first, touch.second);
            touch.next = _lists[place];
            _lists[place] = touch;
        }

        private function remove(touch:TouchRecord):void
        {
            var place:int = placeOf(touch.first, touch.second);
            if (_lists[place] === touch)
            {
                _lists[place] = touch.next;
            }
            else
            {
                var before:TouchRecord = _lists[place];
                while (before.next !== touch)
                {
                    before = before.next;
                }
                before.next = touch.next;
            }
            if (touch.older == null)
            {
                _oldest = touch.newer;
            }
            else
            {
                touch.older.newer = touch.newer;
            }
            if (touch.newer == null)
            {
                _newest = touch.older;
            }
            else
            {
                touch.newer.older = touch.older;
            }
            touch.next = touch.older = touch.newer = null;
            _count--;
        }

        // To a power of two.
        private function resize(length:int):void
        {
            _lists = new Vector.<TouchRecord>(length);
            for (var touch:TouchRecord = _oldest; touch != null; touch = touch.newer)
            {
                enter(touch);
            }
        }
    }
}
