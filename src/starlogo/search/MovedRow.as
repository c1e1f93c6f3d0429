package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.broadphase.Extents;
    import starlogo.engine;

    use namespace engine;

    /**
     * Moves a row of a table to another place for a while, and can make it smaller. So tests can be made with the row at that place. The agent
     * itself does not move.
     *
     * @private
     */
    public final class MovedRow
    {
        /** Half of the row's largest extent. */
        public var largestHalf:Number = 0;

        /** Half of the row's smallest extent. */
        public var leastHalf:Number = 0;

        private var _table:AgentTable;
        private var _row:int;

        // The row as it was before.
        private var _revision:int;
        private var _home:Vector3D = new Vector3D();
        private var _sizing:Vector.<Number> = new Vector.<Number>(8, true);
        private var _isCopied:Boolean = false;

        // Where the row is now, and which part of its size is taken off.
        private var _at:Vector3D = new Vector3D();
        private var _share:Number = 0;

        /** Begins without a row. */
        public function MovedRow()
        {
        }

        /**
         * Begins with a row. Call <code>giveBack()</code> at the end. If an error left the last row displaced, it is put back first. A
         * <code>finally</code> would do so at once, but Adobe's VM makes an object for each call of a method that has a <code>try</code>.
         */
        public function take(table:AgentTable, row:int):void
        {
            giveBack();
            _table = table;
            _row = row;
            _revision = table.revisions[row];
            _home.setTo(table.x[row], table.y[row], table.z[row]);
            _at.x = NaN;
            _isCopied = false;
            var extents:Extents = table.extents;
            largestHalf = extents.largestHalf(row);
            leastHalf = Math.min(extents.halfX[row], Math.min(extents.halfY[row], extents.halfZ[row]));
        }

        /**
         * Puts the row to the place where its agent would be, and makes it smaller about the middle of its extents.
         *
         * @param share the part of its size that is taken off, from 0 to 1
         */
        public function put(place:Vector3D, share:Number):void
        {
            if (share == _share && place.x == _at.x && place.y == _at.y && place.z == _at.z)
            {
                return;
            }
            _at.copyFrom(place);
            shrink(share);
            _table.x[_row] = place.x + share * _sizing[0];
            _table.y[_row] = place.y + share * _sizing[1];
            _table.z[_row] = place.z + share * _sizing[2];
            _table.displace(_row);
        }

        /**
         * Puts the row back to its own place, but smaller.
         *
         * @param share the part of its size that is taken off, from 0 to 1
         */
        public function narrow(share:Number):void
        {
            put(_home, share);
        }

        /** Puts the row back to its own place, with its whole size. Without a row nothing happens. */
        public function giveBack():void
        {
            if (_table != null)
            {
                put(_home, 0);
                _table.revisions[_row] = _revision;
                _table = null;
            }
        }

        // The size is copied only when it changes for the first time, because most rows keep their size.
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
