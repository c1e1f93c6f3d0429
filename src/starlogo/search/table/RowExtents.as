package starlogo.search.table
{
    import starlogo.broadphase.BinLevels;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * The extents of a table's rows. They follow the agents as long as these only change their places.
     *
     * @private
     */
    public final class RowExtents
    {
        /** By row: the extents of the shape. */
        public var extents:Extents = new Extents();

        // By row: the way from the agent's place to the middle of its extents.
        private var _offsets:Points = new Points();

        private var _levels:BinLevels;

        // Whether a row ever had a coarser level because it was far out. From then on each row that moves is assigned a level, so it gets a finer one
        // when it comes back.
        private var _wasOneFarOut:Boolean = false;

        /** @param levels the levels of extents; null if none are needed */
        public function RowExtents(levels:BinLevels)
        {
            _levels = levels;
        }

        /** Makes sure that there are this many rows. */
        public function grow(length:int):void
        {
            _offsets.grow(length);
            extents.grow(length);
        }

        /** Takes the lengths of a body's extents. Its place comes later. */
        public function setLengths(row:int, body:Body):void
        {
            _offsets.x[row] = body.offsetX;
            _offsets.y[row] = body.offsetY;
            _offsets.z[row] = body.offsetZ;
            extents.halfX[row] = body.halfX;
            extents.halfY[row] = body.halfY;
            extents.halfZ[row] = body.halfZ;
            extents.radius[row] = body.radius;
        }

        /** Moves the extents of one row to its agent's place. */
        public function moveRow(row:int, places:Points):void
        {
            extents.x[row] = places.x[row] + _offsets.x[row];
            extents.y[row] = places.y[row] + _offsets.y[row];
            extents.z[row] = places.z[row] + _offsets.z[row];
        }

        /**
         * Moves the extents of rows to the places of their agents.
         *
         * @param shapes by row: the shape; null while it is loading
         */
        public function moveRows(rows:NumberList, places:Points, shapes:Vector.<ModelShape>):void
        {
            var numbers:Vector.<int> = rows.numbers;
            var xs:Vector.<Number> = places.x;
            var ys:Vector.<Number> = places.y;
            var zs:Vector.<Number> = places.z;
            var fromX:Vector.<Number> = _offsets.x;
            var fromY:Vector.<Number> = _offsets.y;
            var fromZ:Vector.<Number> = _offsets.z;
            var middleX:Vector.<Number> = extents.x;
            var middleY:Vector.<Number> = extents.y;
            var middleZ:Vector.<Number> = extents.z;
            var maxDistanceSquared:Number = _levels == null ? Infinity : _levels.maxDistanceSquared;
            if (_wasOneFarOut)
            {
                maxDistanceSquared = 0;
            }
            var end:int = rows.count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = numbers[i];
                var atX:Number = xs[row] + fromX[row];
                var atY:Number = ys[row] + fromY[row];
                var atZ:Number = zs[row] + fromZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                if (atX * atX + atY * atY + atZ * atZ >= maxDistanceSquared)
                {
                    assignLevel(row, shapes);
                }
            }
        }

        /** Finds the levels of rows. The arguments are those of moveRows. */
        public function assignLevels(rows:NumberList, shapes:Vector.<ModelShape>):void
        {
            for (var i:int = 0; i < rows.count; i++)
            {
                assignLevel(rows.numbers[i], shapes);
            }
        }

        private function assignLevel(row:int, shapes:Vector.<ModelShape>):void
        {
            if (_levels != null && shapes[row] != null && _levels.assignLevel(extents, row))
            {
                _wasOneFarOut = true;
            }
        }
    }
}
