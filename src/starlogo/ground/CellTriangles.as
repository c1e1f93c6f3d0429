package starlogo.ground
{
    /**
     * The triangles of a cell of the ground: two on top, and two on each side where a wall stands. A wall stands where a block is higher than its
     * neighbour, at the terrain's borders and around holes. A hole has no triangles.
     */
    internal final class CellTriangles
    {
        // Where the neighbour on each side of a cell is, counter-clockwise from the side with the least y on.
        private static const TO_COLUMN:Vector.<int> = new <int>[0, 1, 0, -1];
        private static const TO_ROW:Vector.<int> = new <int>[-1, 0, 1, 0];

        private var _path:BoxPath;

        // The cell, and the heights of its corners, counter-clockwise.
        private var _column:int = 0;
        private var _row:int = 0;
        private var _tops:Vector.<Number> = new Vector.<Number>(4, true);

        // The index of the cell's next triangle, and the index after its last one. The first two are on top, then come two for each side.
        private var _next:int = 0;
        private var _end:int = 0;

        // How the box passes over the cell within the limits that the search had when it came to the cell. Triangles above and below it are left out.
        private var _passage:SquarePassage;

        // How the box passes over the cell until the latest time at the beginning of the search. Tall walls are cut above and below it, so no corner
        // depends on what the latest time has become.
        private var _wholePassage:SquarePassage = new SquarePassage();

        /** @param path of the boxes over the ground */
        public function CellTriangles(path:BoxPath)
        {
            _path = path;
        }

        /** Leaves the cell, if there is one: there are no more triangles. */
        public function leave():void
        {
            _next = _end = 0;
        }

        /**
         * Goes on to a cell.
         *
         * @param isAtBorder whether it is at a border of the grid
         * @param passage how the box passes over the cell; kept until the next cell
         */
        public function enter(column:int, row:int, isAtBorder:Boolean, passage:SquarePassage):void
        {
            var grid:HeightGrid = _path.search.grid;
            var at:int = row * grid.columns + column;
            leave();
            if (grid.isHole(at))
            {
                return;
            }
            var hasWalls:Boolean = isAtBorder || grid.isBlocky || grid.isBesideHole(at);
            _column = column;
            _row = row;
            _passage = passage;
            readTops(at);
            var greatest:Number = Math.max(Math.max(_tops[0], _tops[1]), Math.max(_tops[2], _tops[3]));
            var least:Number = Math.min(Math.min(_tops[0], _tops[1]), Math.min(_tops[2], _tops[3]));
            if (_passage.low <= greatest && (hasWalls || _passage.high >= least))
            {
                _end = 2;
                if (hasWalls)
                {
                    _wholePassage.from = 0;
                    _wholePassage.to = _path.latest;
                    _path.findPassage(0, column, row, _wholePassage);
                    _end = 10;
                }
            }
        }

        // Reads the heights of the corners. All corners of a block have one height.
        private function readTops(at:int):void
        {
            var grid:HeightGrid = _path.search.grid;
            var heights:Vector.<Number> = grid.heights;
            var next:int = grid.isBlocky ? 0 : 1;
            var far:int = next * grid.columns;
            var z:Number = _path.zeroHeight;
            _tops[0] = heights[at] + z;
            _tops[1] = heights[int(at + next)] + z;
            _tops[2] = heights[int(at + next + far)] + z;
            _tops[3] = heights[int(at + far)] + z;
        }

        /** Writes the next triangle near the box. Returns false if there is none. */
        public function next(out:GroundTriangle):Boolean
        {
            while (_next < _end)
            {
                if (writeTriangle(_next++, out))
                {
                    return true;
                }
            }
            return false;
        }

        // Writes a triangle. Returns false if the cell has no such triangle, or if the box is above or below it.
        private function writeTriangle(index:int, out:GroundTriangle):Boolean
        {
            var corners:Vector.<Number> = out.corners;
            if (index < 2)
            {
                writeCorner(0, corners, 0);
                writeCorner(index + 1, corners, 3);
                writeCorner(index + 2, corners, 6);
            }
            else if (!writeWall((index - 2) >> 1, (index & 1) == 1, corners))
            {
                return false;
            }
            var width:Number = _path.search.grid.cellWidth;
            out.low = Math.min(corners[2], Math.min(corners[5], corners[8]));
            out.high = Math.max(corners[2], Math.max(corners[5], corners[8]));
            out.size = width + out.high - out.low;
            out.cellX = _path.alongX.firstCell + (_column + 0.5) * width;
            out.cellY = _path.alongY.firstCell + (_row + 0.5) * width;
            return _passage.low <= out.high && _passage.high >= out.low;
        }

        // Writes half of the wall on a side, from one corner to the next. The half with the upper edge comes second. Returns false if there is
        // no wall near the box. A wall begins at the top of the lower block. Walls are cut a cell's width above the box and, if the search has no floor,
        // below it, because long triangles have larger rounding errors.
        private function writeWall(side:int, isUpper:Boolean, corners:Vector.<Number>):Boolean
        {
            var grid:HeightGrid = _path.search.grid;
            var floor:Number = _path.search.floor;
            var end:int = (side + 1) & 3;
            var column:int = _column + TO_COLUMN[side];
            var row:int = _row + TO_ROW[side];
            var top:Number = _tops[side];
            var endTop:Number = _tops[end];
            var low:Number = floor;
            if (grid.hasCell(column, row))
            {
                low = grid.isBlocky ? grid.heights[row * grid.columns + column] + _path.zeroHeight : Infinity;
            }
            if (low >= top && low >= endTop || low > _passage.high)
            {
                return false;
            }
            var width:Number = grid.cellWidth;
            if (floor == -Infinity)
            {
                low = Math.max(low, Math.min(_wholePassage.low, Math.min(top, endTop)) - width);
            }
            if (Math.min(top, endTop) > _wholePassage.high + width)
            {
                top = endTop = _wholePassage.high + width;
            }
            writeCorner(side, corners, 0);
            writeCorner(end, corners, 3);
            writeCorner(isUpper ? side : end, corners, 6);
            corners[2] = low;
            corners[5] = isUpper ? endTop : low;
            corners[8] = isUpper ? top : endTop;
            return true;
        }

        // Writes a corner of the cell's top.
        private function writeCorner(corner:int, out:Vector.<Number>, to:int):void
        {
            var width:Number = _path.search.grid.cellWidth;
            out[to] = _path.alongX.firstCell + (_column + ((corner + 1) >> 1 & 1)) * width;
            out[int(to + 1)] = _path.alongY.firstCell + (_row + (corner >> 1)) * width;
            out[int(to + 2)] = _tops[corner];
        }
    }
}
