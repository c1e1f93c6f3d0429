package starlogo.queries.motion
{
    import starlogo.data.SortableIntList;

    /**
     * A list of results of a cast, sorted by time. Its memory is used again.
     *
     * @private
     */
    public final class CastResults
    {
        private var _results:Vector.<CastResult> = new Vector.<CastResult>();

        // Their indices, with the times as keys.
        private var _order:SortableIntList = new SortableIntList();

        /** The number of results. */
        public function get count():int
        {
            return _order.count;
        }

        /** Removes all results. */
        public function clear():void
        {
            _order.count = 0;
        }

        /** The result that <code>add()</code> would add. The caller writes to it. */
        public function get next():CastResult
        {
            if (count == _results.length)
            {
                _results.push(new CastResult());
            }
            return _results[count];
        }

        /** Adds the next result at the end. */
        public function add():void
        {
            _order.add(count, next.time);
        }

        /** Sorts the results by time. Results with the same time keep their order. */
        public function sortByTime():void
        {
            _order.sortFirst(count);
        }

        /** A result. The index <code>count</code> is that of the next one. */
        public function at(index:int):CastResult
        {
            return index == count ? next : _results[_order.values[index]];
        }
    }
}
