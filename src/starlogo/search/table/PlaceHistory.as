package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.BinLevels;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Where the agents of a table were in the last two searches, and which of them have changed. An agent's motion goes from one place to the other.
     * The extents of the shapes follow the places of the last search.
     *
     * @private
     */
    public final class PlaceHistory
    {
        /** By row: the extents of the shape at the place in the last search. */
        public var extents:Extents = new Extents();

        /** The places in the last search. */
        public var last:RowPlaces = new RowPlaces();

        /** The places in the search before the last. A row that has not changed has the same place in both. */
        public var previous:RowPlaces = new RowPlaces();

        /** The rows that the last search has read again, because their agents had changed. */
        public var changed:IntList = new IntList();

        /** The rows that the search before has read again. */
        public var previouslyChanged:IntList = new IntList();

        /** The rows that the next search has read again, before it is accepted. */
        internal var proposed:IntList = new IntList();

        // By row: the way from the agent's place to the middle of its extents.
        private var _offsets:Points = new Points();

        /** The levels for extents; null if none are needed. */
        public var levels:BinLevels;

        // Whether a row ever had a coarser level because it was far out. From then on each row that moves is assigned a level, so it gets a finer one
        // when it comes back.
        private var _wasOneFarOut:Boolean = false;

        /** @param levels for extents; null if none are needed */
        public function PlaceHistory(levels:BinLevels)
        {
            this.levels = levels;
        }

        /**
         * The places of the next search, before it is accepted: those of the search before the last, which nobody needs any more. If the next search is
         * refused, the one after it reads the same rows again.
         */
        internal function get next():RowPlaces
        {
            return previous;
        }

        /**
         * Makes the next places and the proposed rows those of the last search.
         *
         * @param listedCount the number of agents in the list
         */
        internal function accept(listedCount:int):void
        {
            var older:RowPlaces = previous;
            previous = last;
            last = older;
            var spare:IntList = previouslyChanged;
            previouslyChanged = changed;
            changed = proposed;
            proposed = spare;
            // A row that has changed in the search before, and not since, has an older place here. There is none if all have changed now.
            for (var i:int = 0; i < previouslyChanged.count && changed.count < listedCount; i++)
            {
                var row:int = previouslyChanged.numbers[i];
                if (last.revisions[row] < previous.revisions[row])
                {
                    last.copyRow(previous, row);
                }
            }
            moveExtents();
        }

        /** Reads the extents of a row's body, which has another shape, turn or size than before. */
        public function readExtents(row:int, body:Body):void
        {
            _offsets.x[row] = body.offsetX;
            _offsets.y[row] = body.offsetY;
            _offsets.z[row] = body.offsetZ;
            extents.halfX[row] = body.halfX;
            extents.halfY[row] = body.halfY;
            extents.halfZ[row] = body.halfZ;
            extents.radius[row] = body.radius;
            extents.offset[row] = body.offset;
            moveExtentsOf(row);
            assignLevel(row);
        }

        /** Reads the place of one agent as it is now. It has no motion then. */
        public function readNow(row:int, agent:Agent):void
        {
            last.read(row, agent);
            previous.read(row, agent);
            moveExtentsOf(row);
        }

        /** Makes room for so many rows, which are more than before. */
        public function grow(length:int):void
        {
            last.grow(length);
            previous.grow(length);
            extents.grow(length);
            _offsets.grow(length);
        }

        private function moveExtentsOf(row:int):void
        {
            extents.x[row] = last.x[row] + _offsets.x[row];
            extents.y[row] = last.y[row] + _offsets.y[row];
            extents.z[row] = last.z[row] + _offsets.z[row];
        }

        // Moves the extents of the rows that have changed.
        private function moveExtents():void
        {
            var numbers:Vector.<int> = changed.numbers;
            var xs:Vector.<Number> = last.x;
            var ys:Vector.<Number> = last.y;
            var zs:Vector.<Number> = last.z;
            var fromX:Vector.<Number> = _offsets.x;
            var fromY:Vector.<Number> = _offsets.y;
            var fromZ:Vector.<Number> = _offsets.z;
            var middleX:Vector.<Number> = extents.x;
            var middleY:Vector.<Number> = extents.y;
            var middleZ:Vector.<Number> = extents.z;
            var maxDistanceSquared:Number = levels == null ? Infinity : levels.maxDistanceSquared;
            if (_wasOneFarOut)
            {
                maxDistanceSquared = 0;
            }
            var end:int = changed.count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = numbers[i];
                var atX:Number = xs[row] + fromX[row];
                var atY:Number = ys[row] + fromY[row];
                var atZ:Number = zs[row] + fromZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                // a new row has no level, and its extents are not known yet
                if (atX * atX + atY * atY + atZ * atZ >= maxDistanceSquared && extents.level[row] != 0)
                {
                    assignLevel(row);
                }
            }
        }

        // The ground and the edges of the world are in no bins.
        private function assignLevel(row:int):void
        {
            if (levels != null && row >= ListedAgents.FIRST_LISTED && levels.assign(extents, row))
            {
                _wasOneFarOut = true;
            }
        }
    }
}
