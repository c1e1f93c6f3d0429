package starlogo.fitting.hull
{
    /**
     * A queue of edges, a binary heap. The edge with the least cost is the first.
     *
     * @private
     */
    public final class EdgeQueue
    {
        private var _edges:Vector.<int> = new Vector.<int>();
        private var _costs:Vector.<Number> = new Vector.<Number>();

        // By edge: 1 if it is in the queue, otherwise 0. Edges beyond the end are not in it.
        private var _isQueued:Vector.<int> = new Vector.<int>();

        /** Whether there are no edges. */
        public function get isEmpty():Boolean
        {
            return _edges.length == 0;
        }

        /** The least cost; infinity if there are no edges. */
        public function get leastCost():Number
        {
            return isEmpty ? Infinity : _costs[0];
        }

        /** Whether an edge is in the queue. */
        public function has(edge:int):Boolean
        {
            return edge < _isQueued.length && _isQueued[edge] == 1;
        }

        /** Adds an edge, which is not in the queue. */
        public function push(edge:int, cost:Number):void
        {
            var at:int = _edges.length;
            if (edge >= _isQueued.length)
            {
                _isQueued.length = 2 * edge + 1;
            }
            _isQueued[edge] = 1;
            _edges[at] = edge;
            _costs[at] = cost;
            while (at > 0)
            {
                var parent:int = (at - 1) >> 1;
                if (_costs[parent] <= cost)
                {
                    break;
                }
                _edges[at] = _edges[parent];
                _costs[at] = _costs[parent];
                at = parent;
            }
            _edges[at] = edge;
            _costs[at] = cost;
        }

        /** Removes an edge with the least cost, and returns it. There must be an edge. */
        public function pop():int
        {
            var first:int = _edges[0];
            _isQueued[first] = 0;
            var edge:int = _edges.pop();
            var count:int = _edges.length;
            var cost:Number = _costs[count];
            _costs.length = count;
            if (count > 0)
            {
                var at:int = 0;
                var child:int = 1;
                while (child < count)
                {
                    if (child + 1 < count && _costs[child + 1] < _costs[child])
                    {
                        child++;
                    }
                    if (_costs[child] >= cost)
                    {
                        break;
                    }
                    _edges[at] = _edges[child];
                    _costs[at] = _costs[child];
                    at = child;
                    child = 2 * at + 1;
                }
                _edges[at] = edge;
                _costs[at] = cost;
            }
            return first;
        }
    }
}
