package starlogo.search
{
    import starlogo.broadphase.Extents;
    import starlogo.engine;

    use namespace engine;

    /**
     * Takes a row of a table elsewhere for a while, as large as it is or smaller, so that questions can be asked about it there.
     *
     * @private
     */
    public final class MovedRow
    {
        /** Half the row's largest extent. */
        public var largestHalf:Number = 0;

        /** Half its least extent. */
        public var leastHalf:Number = 0;

        private var _table:AgentTable;
        private var _row:int;

        // The row as it was taken.
        private var _revision:int;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _sizing:Vector.<Number> = new Vector.<Number>(8, true);
        private var _isCopied:Boolean = false;

        // Where it is, and how much smaller.
        private var _atX:Number = NaN;
        private var _atY:Number = 0;
        private var _atZ:Number = 0;
        private var _share:Number = 0;

        /** No row. */
        public function MovedRow()
        {
        }

        /** Takes a row; <code>giveBack()</code> has to follow. */
        public function take(table:AgentTable, row:int):void
        {
            _table = table;
            _row = row;
            _revision = table.revisions[row];
            _x = table.x[row];
            _y = table.y[row];
            _z = table.z[row];
            _atX = NaN;
            _isCopied = false;
            var extents:Extents = table.extents;
            largestHalf = Math.max(extents.halfX[row], Math.max(extents.halfY[row], extents.halfZ[row]));
            leastHalf = Math.min(extents.halfX[row], Math.min(extents.halfY[row], extents.halfZ[row]));
        }

        /**
         * Puts the row where its agent would be at a place, smaller about the middle of its extents.
         *
         * @param share of its size that is taken off, from 0 to 1
         */
        public function put(x:Number, y:Number, z:Number, share:Number):void
        {
            if (x == _atX && y == _atY && z == _atZ && share == _share)
            {
                return;
            }
            _atX = x;
            _atY = y;
            _atZ = z;
            shrink(share);
            _table.x[_row] = x + share * _sizing[0];
            _table.y[_row] = y + share * _sizing[1];
            _table.z[_row] = z + share * _sizing[2];
            _table.displace(_row);
        }

        /** Puts the row back where it was, but smaller. */
        public function narrow(share:Number):void
        {
            put(_x, _y, _z, share);
        }

        /** Puts the row back as it was. */
        public function giveBack():void
        {
            shrink(0);
            _table.x[_row] = _x;
            _table.y[_row] = _y;
            _table.z[_row] = _z;
            _table.putBack(_row, _revision);
            _table = null;
        }

        /** Whether the extents of the row, where it is, are no farther from those of another than a gap. */
        public function isNear(other:int, gap:Number):Boolean
        {
            var extents:Extents = _table.extents;
            var row:int = _row;
            return Math.abs(extents.x[row] - extents.x[other]) <= extents.halfX[row] + extents.halfX[other] + gap
                && Math.abs(extents.y[row] - extents.y[other]) <= extents.halfY[row] + extents.halfY[other] + gap
                && Math.abs(extents.z[row] - extents.z[other]) <= extents.halfZ[row] + extents.halfZ[other] + gap;
        }

        // Mostly a row stays as large as it is, and its size is not copied.
        private function shrink(share:Number):void
        {
            if (share == _share)
            {
                return;
            }
            if (!_isCopied)
            {
                _table.readSizing(_row, _sizing);
                _isCopied = true;
            }
            _table.writeSizing(_row, _sizing, 1 - share);
            _share = share;
        }
    }
}
