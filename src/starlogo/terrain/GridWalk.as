package starlogo.terrain
{
    /**
     * Walks over a grid, and finds the squares that a box passes over, row by row. If the box moves, the walk follows its way. Each square
     * comes with the heights between which the box is there.
     */
    internal final class GridWalk
    {
        /** The current square: its column and its row. */
        public var column:int = 0;

        /** @copy #column */
        public var row:int = 0;

        /** The least height of the box over it. */
        public var low:Number = 0;

        /** The greatest height of the box over it. */
        public var high:Number = 0;

        /** How wide a square is. */
        public var width:Number = 1;

        /** Where the first square begins. */
        public var originX:Number = 0;

        /** @copy #originX */
        public var originY:Number = 0;

        private var _box:PassingBox;
        private var _isStanding:Boolean = true;

        // The first and the last column that count. The next column, and how many are left in the row. The next row, and how many are left. The
        // part of the way that is over the current row.
        private var _first:int = 0;
        private var _last:int = 0;
        private var _next:int = 0;
        private var _left:int = 0;
        private var _nextRow:int = 0;
        private var _rowsLeft:int = 0;
        private var _from:Number = 0;
        private var _to:Number = 0;

        // Argument of indexOf: a distance from the first square's beginning. A field, because V8 allocates an object for each Number that is
        // passed.
        private var _at:Number = 0;

        /** @param box the box to follow; kept */
        public function GridWalk(box:PassingBox)
        {
            _box = box;
        }

        /**
         * Begins a walk over some squares.
         *
         * @param first the first column that counts
         * @param firstRow the first row that counts
         * @param last the last column that counts
         * @param lastRow the last row that counts
         */
        public function begin(first:int, firstRow:int, last:int, lastRow:int):void
        {
            var box:PassingBox = _box;
            _isStanding = box.wayX == 0 && box.wayY == 0 && box.wayZ == 0;
            _first = first;
            _last = last;
            var end:Number = box.y + box.limit * box.wayY;
            _at = (box.y < end ? box.y : end) - box.halfY - originY;
            var nearest:int = indexOf(firstRow, lastRow + 1);
            _at = (box.y > end ? box.y : end) + box.halfY - originY;
            var farthest:int = indexOf(firstRow - 1, lastRow);
            _rowsLeft = farthest - nearest + 1;
            _nextRow = box.wayY < 0 ? farthest : nearest;
            _left = 0;
        }

        /** Goes on to the next square. Returns false if there is none. */
        public function next():Boolean
        {
            while (true)
            {
                while (_left > 0)
                {
                    _left--;
                    column = _next;
                    _next += _box.wayX < 0 ? -1 : 1;
                    if (_isStanding)
                    {
                        low = _box.z - _box.halfZ;
                        high = _box.z + _box.halfZ;
                        return true;
                    }
                    if (isOver())
                    {
                        return true;
                    }
                }
                if (_rowsLeft <= 0)
                {
                    return false;
                }
                _rowsLeft--;
                row = _nextRow;
                _nextRow += _box.wayY < 0 ? -1 : 1;
                beginRow();
            }
            return false;
        }

        // Finds the columns that the box passes over in the row.
        private function beginRow():void
        {
            var box:PassingBox = _box;
            box.from = 0;
            box.to = box.limit;
            if (!_isStanding)
            {
                box.cut(box.y, box.halfY, box.wayY, originY + row * width, originY + (row + 1) * width);
            }
            _from = box.from;
            _to = box.to;
            if (_from > _to)
            {
                return;
            }
            var start:Number = box.x + _from * box.wayX;
            var end:Number = box.x + _to * box.wayX;
            _at = (start < end ? start : end) - box.halfX - originX;
            var nearest:int = indexOf(_first, _last + 1);
            _at = (start > end ? start : end) + box.halfX - originX;
            var farthest:int = indexOf(_first - 1, _last);
            _left = farthest - nearest + 1;
            _next = box.wayX < 0 ? farthest : nearest;
        }

        // Whether the box passes over the current square, within the limit. Also finds the heights between which the box is there.
        private function isOver():Boolean
        {
            var box:PassingBox = _box;
            box.from = _from;
            box.to = _to < box.limit ? _to : box.limit;
            box.cut(box.x, box.halfX, box.wayX, originX + column * width, originX + (column + 1) * width);
            var start:Number = box.z + box.from * box.wayZ;
            var end:Number = box.z + box.to * box.wayZ;
            low = (start < end ? start : end) - box.halfZ;
            high = (start > end ? start : end) + box.halfZ;
            return box.from <= box.to;
        }

        // The column or row at the place, clamped to the bounds.
        private function indexOf(least:int, greatest:int):int
        {
            var at:Number = Math.floor(_at / width);
            return at > least ? (at < greatest ? at : greatest) : least;
        }
    }
}
