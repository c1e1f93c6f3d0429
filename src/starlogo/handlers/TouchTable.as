package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.data.HashTable;
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.engine;

    use namespace engine;

    /**
     * The touches of a Collision, by their two agents. Objects of ended touches are used again, so it allocates nothing unless there are more touches
     * than before.
     *
     * @private
     */
    public final class TouchTable
    {
        // In place of the last frame of a touch: it has ended.
        private static const NONE:int = int.MAX_VALUE;

        /** The number of touches that have not ended. Read only. */
        public var count:int = 0;

        /** By index: all touches that there are, and objects for later ones, which have no agents. Read only. */
        public var all:Vector.<Touch> = new Vector.<Touch>();

        /** By index: the tracker's last frame in which the touch began or went on; NONE for an object without a touch. */
        public var lastFrames:Vector.<int> = new Vector.<int>();

        // By the ids of the first and of the second agent: the index of their touch.
        private var _indices:HashTable = new HashTable();

        // The indices of the objects for later touches.
        private var _free:IntList = new IntList();

        // The number of touches that ever began.
        private var _startedCount:Number = 0;

        /** The touch of two agents, in either order; null if there is none. */
        public function find(a:Agent, b:Agent):Touch
        {
            var index:int = _indices.find(a.idNumber, b.idNumber);
            if (index < 0)
            {
                index = _indices.find(b.idNumber, a.idNumber);
            }
            return index < 0 ? null : all[index];
        }

        /** Begins a touch of two agents that have none, of these breeds, in a frame of the tracker. No handler has been called for it. */
        public function start(first:Agent, second:Agent, firstBreed:int, secondBreed:int, frame:int):Touch
        {
            var touch:Touch = newTouch();
            touch.first = first;
            touch.second = second;
            touch.firstBreed = firstBreed;
            touch.secondBreed = secondBreed;
            lastFrames[touch.index] = frame;
            touch.isComplete = false;
            touch.serial = _startedCount;
            _startedCount++;
            count++;
            _indices.set (first.idNumber, second.idNumber, touch.index);
            return touch;
        }

        /** Ends a touch. It keeps its agents until <code>release()</code>. */
        public function end(touch:Touch):void
        {
            _indices.remove(touch.first.idNumber, touch.second.idNumber);
            lastFrames[touch.index] = NONE;
            count--;
        }

        /** Lets a later touch use the object of one that has ended. */
        public function release(touch:Touch):void
        {
            touch.first = touch.second = null;
            _free.add(touch.index);
        }

        /** Returns all touches, in the order in which they began. Call it between two frames. */
        public function inOrder():Vector.<Touch>
        {
            var order:SortableIntList = new SortableIntList();
            for (var i:int = 0; i < all.length; i++)
            {
                if (all[i].first != null)
                {
                    order.add(i, all[i].serial);
                }
            }
            order.sortFirst(order.count);
            var ordered:Vector.<Touch> = new Vector.<Touch>();
            for (i = 0; i < order.count; i++)
            {
                ordered.push(all[order.values[i]]);
            }
            return ordered;
        }

        private function newTouch():Touch
        {
            if (_free.count > 0)
            {
                _free.count--;
                return all[_free.values[_free.count]];
            }
            var touch:Touch = new Touch();
            touch.index = all.push(touch) - 1;
            return touch;
        }
    }
}
