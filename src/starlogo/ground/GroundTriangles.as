package starlogo.ground
{
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the triangles of the ground's surface that a box may meet, one after the other: the source of triangles for all tests of the
     * ground, and for drawing it. If the box moves, they come nearly in the order in which it meets them. For a distance,
     * those of the nearest cells come first.
     *
     * <p>The surface consists of the cells' tops and of upright walls. A wall between two blocks goes down to the top of the lower one, every other
     * wall to the search's floor. Tall walls are cut above the box, and below it if the search has no floor.</p>
     *
     * <p>A stack has the squares that are still to be visited. If the box comes to the heights of a square, its smaller squares take its
     * place. The smallest squares, of level 0, are the cells.</p>
     *
     * @private
     */
    public final class GroundTriangles
    {
        /** The path of the box. Read only. */
        internal var path:BoxPath = new BoxPath();

        // Of the current square: how the box passes over it, its heights, and if it is a cell, its triangles.
        private var _passage:SquarePassage = new SquarePassage();
        private var _heights:HeightBounds = new HeightBounds();
        private var _cell:CellTriangles = new CellTriangles(path, _passage);

        // Level, column and row of each square that is still to be visited, and how many numbers these are.
        private var _squares:Vector.<int> = new Vector.<int>();
        private var _squaresEnd:int = 0;

        /** Begins with all triangles of the cells in some columns and rows. All walls go down to the lowest height. */
        public function beginWithCells(grid:HeightGrid, firstColumn:int, firstRow:int, lastColumn:int, lastRow:int):void
        {
            var search:GroundSearch = new GroundSearch();
            search.grid = grid;
            search.floor = grid.pyramid.whole.min;
            search.box.halfX = search.box.halfY = search.box.halfZ = Infinity;
            reset(search);
            addSquares(0, firstColumn, firstRow, lastColumn, lastRow);
        }

        /** Begins a search, which is kept until it ends. Returns whether it begins with cells, because the box comes to few, and not with larger squares. */
        internal function begin(search:GroundSearch):Boolean
        {
            reset(search);
            var level:int = path.firstLevel();
            addSquares(level, 0, 0, int.MAX_VALUE, int.MAX_VALUE);
            return level == 0;
        }

        private function reset(search:GroundSearch):void
        {
            stop();
            path.begin(search);
            _passage.earliest = 0;
            _passage.latest = search.motion.latestTime;
        }

        /** Ends: there is no next triangle. */
        internal function stop():void
        {
            _cell.stop();
            _squaresEnd = 0;
        }

        /** Writes the next triangle. Returns false if there is none. */
        public function next(out:GroundTriangle):Boolean
        {
            while (!_cell.next(out))
            {
                if (_squaresEnd == 0)
                {
                    return false;
                }
                visitSquare();
            }
            return true;
        }

        // Puts the squares of a level in some columns and rows on the stack if the box may pass over them in the current passage. The one that the box comes to
        // first is put last, and visited first.
        private function addSquares(level:int, firstColumn:int, firstRow:int, lastColumn:int, lastRow:int):void
        {
            var motion:RelativeMotion = path.search.motion;
            lastColumn = Math.min(lastColumn, HeightPyramid.squareOf(path.alongX.lastCell, level));
            lastRow = Math.min(lastRow, HeightPyramid.squareOf(path.alongY.lastCell, level));
            var left:int = Math.max(firstColumn, path.firstSquareAlong(path.alongX, _passage, level));
            var right:int = Math.min(lastColumn, path.lastSquareAlong(path.alongX, _passage, level));
            var bottom:int = Math.max(firstRow, path.firstSquareAlong(path.alongY, _passage, level));
            var top:int = Math.min(lastRow, path.lastSquareAlong(path.alongY, _passage, level));
            if (path.search.maxDistance > 0)
            {
                addByDistance(level, left, bottom, right, top);
                return;
            }
            for (var row:int = bottom; row <= top; row++)
            {
                for (var column:int = left; column <= right; column++)
                {
                    _squares[_squaresEnd] = level;
                    _squares[int(_squaresEnd + 1)] = motion.x < 0 ? column : left + right - column;
                    _squares[int(_squaresEnd + 2)] = motion.y < 0 ? row : bottom + top - row;
                    _squaresEnd += 3;
                }
            }
        }

        // Puts squares on the stack for a distance: the row and the column nearest to the box's middle last. A function of its own, so that V8 inlines the other.
        private function addByDistance(level:int, left:int, bottom:int, right:int, top:int):void
        {
            var nearColumn:int = path.middleAlong(path.alongX, level);
            var nearRow:int = path.middleAlong(path.alongY, level);
            while (bottom <= top)
            {
                var row:int = nearRow - bottom > top - nearRow ? bottom++ : top--;
                var first:int = left;
                var last:int = right;
                while (first <= last)
                {
                    _squares[_squaresEnd] = level;
                    _squares[int(_squaresEnd + 1)] = nearColumn - first > last - nearColumn ? first++ : last--;
                    _squares[int(_squaresEnd + 2)] = row;
                    _squaresEnd += 3;
                }
            }
        }

        // Takes a square from the stack. If the box comes to its heights, continues with its smaller squares, or with the cell's triangles.
        private function visitSquare():void
        {
            _squaresEnd -= 3;
            var level:int = _squares[_squaresEnd];
            var column:int = _squares[int(_squaresEnd + 1)];
            var row:int = _squares[int(_squaresEnd + 2)];
            _passage.latest = path.search.motion.latestTime;
            if (!path.clipToSquare(level, column, row, _passage))
            {
                return;
            }
            if (level == 0)
            {
                _cell.begin(column, row);
                return;
            }
            readHeights(level, column, row);
            if (!_heights.isAllHoles && _passage.minHeight <= _heights.max && _passage.maxHeight >= _heights.min
                    && !path.isBeyondMaxDistance(level, column, row, _heights))
            {
                column <<= HeightPyramid.SHIFT;
                row <<= HeightPyramid.SHIFT;
                addSquares(level - 1, column, row, column + HeightPyramid.SQUARES_PER_SIDE - 1, row + HeightPyramid.SQUARES_PER_SIDE - 1);
            }
        }

        // Reads between which heights the triangles of the current square are. Walls go down to below the box.
        private function readHeights(level:int, column:int, row:int):void
        {
            var grid:HeightGrid = path.search.grid;
            grid.pyramid.findRange(level, column, row, column, row, _heights);
            _heights.min -= path.search.origin.z;
            _heights.max -= path.search.origin.z;
            if (path.isAtBorder(level, column, row) || _heights.hasHole)
            {
                _heights.min = Math.min(_heights.min, _passage.minHeight);
            }
        }
    }
}
