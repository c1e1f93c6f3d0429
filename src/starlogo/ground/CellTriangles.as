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

        // A cell's triangles in their order: two on top, then two for each of the four sides.
        private static const TOPS_END:int = 2;
        private static const WALLS_END:int = 10;

        private var _path:BoxPath;

        // The cell, and the corners of its top, counter-clockwise from the one with the least x and y on.
        private var _column:int = 0;
        private var _row:int = 0;
        private var _tops:Vector.<Number> = new Vector.<Number>(12, true);

        // The index of the cell's next triangle, and the end of its triangles: 0, TOPS_END or WALLS_END.
        private var _next:int = 0;
        private var _end:int = 0;

        // How the box passes over the cell within the limits that the search had when it came to the cell. Triangles above and below it are left out.
        private var _passage:SquarePassage;

        // How the box passes over the cell until the latest time at the beginning of the GroundTriangles' search. Tall walls are cut above and below it, so
        // no corner depends on what the latest time has become since.
        private var _longestPassage:SquarePassage = new SquarePassage();

        /**
         * @param path of the boxes over the ground
         * @param passage how the box passes over the current cell; the caller clips it to each cell
         */
        public function CellTriangles(path:BoxPath, passage:SquarePassage)
        {
            _path = path;
            _passage = passage;
        }

        /** Ends: there is no next triangle. */
        public function stop():void
        {
            _next = _end = 0;
        }

        /** Begins with a cell. */
        public function begin(column:int, row:int):void
        {
            var grid:HeightGrid = _path.search.grid;
            var at:int = row * grid.columns + column;
            var hasHoles:Boolean = grid.pyramid.whole.hasHole;
            stop();
            if (hasHoles && grid.isHole(at))
            {
                return;
            }
            _column = column;
            _row = row;
            readTops(at);
            var tops:Vector.<Number> = _tops;
            // comparisons take the player less time than Math.min() and Math.max()
            var low:Number = tops[2] < tops[5] ? tops[2] : tops[5];
            low = low < tops[8] ? low : tops[8];
            low = low < tops[11] ? low : tops[11];
            var high:Number = tops[2] > tops[5] ? tops[2] : tops[5];
            high = high > tops[8] ? high : tops[8];
            high = high > tops[11] ? high : tops[11];
            var hasWalls:Boolean = grid.isBlocky || _path.isAtBorder(0, column, row) || hasHoles && grid.isBesideHole(at);
            if (_passage.minHeight <= high && (hasWalls || _passage.maxHeight >= low))
            {
                _end = TOPS_END;
                if (hasWalls)
                {
                    _longestPassage.latest = _path.latestAtBegin;
                    _path.clipToSquare(0, column, row, _longestPassage);
                    _end = WALLS_END;
                }
            }
        }

        // Reads the corners of the cell. All corners of a block have one height.
        private function readTops(at:int):void
        {
            var grid:HeightGrid = _path.search.grid;
            var heights:Vector.<Number> = grid.heights;
            var next:int = grid.isBlocky ? 0 : 1;
            var rowStep:int = next * grid.columns;
            var tops:Vector.<Number> = _tops;
            tops[0] = tops[9] = _path.alongX.cellsBegin + _column * grid.cellWidth;
            tops[3] = tops[6] = _path.alongX.cellsBegin + (_column + 1) * grid.cellWidth;
            tops[1] = tops[4] = _path.alongY.cellsBegin + _row * grid.cellWidth;
            tops[7] = tops[10] = _path.alongY.cellsBegin + (_row + 1) * grid.cellWidth;
            tops[2] = heights[at] - _path.search.origin.z;
            tops[5] = heights[int(at + next)] - _path.search.origin.z;
            tops[8] = heights[int(at + next + rowStep)] - _path.search.origin.z;
            tops[11] = heights[int(at + rowStep)] - _path.search.origin.z;
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
            out.isWall = index >= TOPS_END;
            if (!out.isWall)
            {
                // the first half of the top is beside the side with the greatest x
                copyTops(0, index + 1, index + 2, corners);
            }
            else if (!writeWall((index - TOPS_END) >> 1, (index & 1) == 1, corners))
            {
                return false;
            }
            var low:Number = corners[2] < corners[5] ? corners[2] : corners[5];
            low = low < corners[8] ? low : corners[8];
            var high:Number = corners[2] > corners[5] ? corners[2] : corners[5];
            high = high > corners[8] ? high : corners[8];
            out.radius = _path.search.grid.cellWidth + high - low;
            return _passage.minHeight <= high && _passage.maxHeight >= low;
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
            var top:Number = _tops[int(3 * side + 2)];
            var endTop:Number = _tops[int(3 * end + 2)];
            var low:Number = floor;
            if (grid.hasCell(column, row))
            {
                // no wall is between two slopes
                low = grid.isBlocky ? grid.heights[row * grid.columns + column] - _path.search.origin.z : Infinity;
            }
            var upper:Number = isUpper ? top : endTop;
            // with no upper edge, the half is empty
            if (low >= upper || low > _passage.maxHeight)
            {
                return false;
            }
            var width:Number = grid.cellWidth;
            if (floor == -Infinity)
            {
                low = Math.max(low, Math.min(_longestPassage.minHeight, Math.min(top, endTop)) - width);
            }
            if (Math.min(top, endTop) > _longestPassage.maxHeight + width)
            {
                top = endTop = _longestPassage.maxHeight + width;
            }
            copyTops(side, end, isUpper ? side : end, corners);
            corners[2] = low;
            corners[5] = isUpper ? endTop : low;
            corners[8] = isUpper ? top : endTop;
            return true;
        }

        // Copies three corners of the cell's top.
        private function copyTops(first:int, second:int, third:int, out:Vector.<Number>):void
        {
            first *= 3;
            second *= 3;
            third *= 3;
            out[0] = _tops[first];
            out[1] = _tops[int(first + 1)];
            out[2] = _tops[int(first + 2)];
            out[3] = _tops[second];
            out[4] = _tops[int(second + 1)];
            out[5] = _tops[int(second + 2)];
            out[6] = _tops[third];
            out[7] = _tops[int(third + 1)];
            out[8] = _tops[int(third + 2)];
        }
    }
}
