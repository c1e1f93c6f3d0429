package starlogo.queries.motion
{
    import starlogo.engine;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.SweptBoxSearch;
    import starlogo.search.ModelShape;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Finds the rows that a MovingBody may meet on its way. All its methods take the body where its motion begins. Those that take a filter write the rows
     * of the body. They call the filter's <code>accepts</code>, which may ask other questions.
     *
     * @private
     */
    public final class NearRows
    {
        private var _seen:SeenAgents;
        private var _search:SweptBoxSearch = new SweptBoxSearch();

        /** @param seen has the rows */
        public function NearRows(seen:SeenAgents)
        {
            _seen = seen;
        }

        /** Finds the rows near the wanted motion of a body, if it is straight. */
        public function findAlong(body:MovingBody, filter:AgentFilter):void
        {
            if (searchAround(body))
            {
                _search.moveAlong(body.motion);
                collect(body, filter);
            }
        }

        /**
         * Finds the rows near motions that are not known yet, and near the pushes with which they begin.
         *
         * @param range how far the body may go in any direction, without pushes
         * @param up how much farther than the range it may go upwards
         * @param down how much farther than the range it may go downwards
         */
        public function findWithin(body:MovingBody, range:Number, up:Number, down:Number, filter:AgentFilter):void
        {
            if (searchAround(body))
            {
                var largest:Number = extentBoundFor(body);
                var reach:Number = range + maxSlop(body, range, largest);
                if (ShrunkBody.SHALLOW * largest > body.extent)
                {
                    // such long pushes come only from what is near the way, and that may be small
                    _search.inflate(reach, up, down);
                    collect(body, null);
                    largest = body.largestExtentAmong(body.rows);
                    searchAround(body);
                }
                _search.inflate(reach + ShrunkBody.SHALLOW * largest, up, down);
                collect(body, filter);
            }
        }

        /** The slop of a motion of at most this length is no larger, if the body and the rows near its way have no larger extents than this. */
        public function maxSlop(body:MovingBody, length:Number, largest:Number):Number
        {
            var ground:ModelShape = _seen.table.shapes[ListedAgents.GROUND_ROW];
            var cell:Number = ground == null ? 0 : ground.grid.cellWidth;
            return ShrunkBody.slopOf(body.extent, largest, body.from, 2 * length + cell);
        }

        /** An upper bound of the extents of all rows and the body. It reads the ground too. */
        public function extentBoundFor(body:MovingBody):Number
        {
            return Math.max(body.extent, _seen.treeOfExtents().maxExtent);
        }

        // Begins a search around a body, and forgets its rows. Returns whether the body has a shape.
        private function searchAround(body:MovingBody):Boolean
        {
            body.rows.count = 0;
            if (body.hasShape)
            {
                _search.setAround(_seen.treeOfExtents(), body.moveTo(body.from));
            }
            return body.hasShape;
        }

        private function collect(body:MovingBody, filter:AgentFilter):void
        {
            var collector:Collector = _seen.beginCollecting(Collector.ALL, 1, body.agent, filter);
            for (var row:int = _search.next(collector); row >= 0; row = _search.next(collector))
            {
                collector.add(row, 0);
            }
            var count:int = collector.end();
            for (var i:int = 0; i < count; i++)
            {
                body.rows.add(collector.rowAt(i));
            }
        }
    }
}
