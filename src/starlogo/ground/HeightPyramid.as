package starlogo.ground
{
    /**
     * A min-max mipmap of the heights of a grid: for squares of its cells the least height, the greatest height, and how much neighbours differ. A square of
     * level 1 is 8 cells wide, and a square of each next level is 8 squares wide. The last level is one square.
     *
     * <p>The heights and the holes around a square count too, because walls lead to them, and slopes end at the next square's first heights.</p>
     *
     * @private
     */
    public final class HeightPyramid
    {
        /** How many squares of a level a square of the next level is wide, as a shift. */
        public static const SHIFT:int = 3;
        public static const SQUARES_PER_SIDE:int = 1 << SHIFT;

        // A range is not read square by square if it is longer than this, along x or along y. Smaller: bounds are wider, and decide about fewer agents.
        // Larger: finding them takes longer.
        private static const MAX_SQUARES:int = 16;

        // How many numbers a square has: the least height, the greatest height, the greatest difference of two heights that are neighbours along x, the same
        // along y, and 2 if all cells there are holes, 1 if one is, or 0.
        private static const NUMBERS_PER_SQUARE:int = 5;

        /** The number of the last level. Level 0 is the cells, whose heights need no bounds. */
        public var lastLevel:int = 0;

        /** Bounds of all heights. Read only. */
        public var whole:HeightBounds = new HeightBounds();

        private var _grid:HeightGrid;

        // The numbers of all squares, level by level and row by row; and by level, where its squares begin.
        private var _bounds:Vector.<Number>;
        private var _begins:Vector.<int> = new <int>[0];

        private var _range:HeightBounds = new HeightBounds();

        /** @param grid has the heights, which are 0 */
        public function HeightPyramid(grid:HeightGrid)
        {
            var size:int = 0;
            _grid = grid;
            while (countSquares(grid.columns, lastLevel) > 1 || countSquares(grid.rows, lastLevel) > 1)
            {
                lastLevel++;
                _begins.push(size);
                size += NUMBERS_PER_SQUARE * countSquares(grid.columns, lastLevel) * countSquares(grid.rows, lastLevel);
            }
            _bounds = new Vector.<Number>(size, true);
            findWhole();
        }

        /** In which column or row of a level's squares a column or a row of cells is. */
        public static function squareOf(cell:int, level:int):int
        {
            return cell >> level * SHIFT;
        }

        // How many squares of a level there are along a row or a column with this many heights. The last height counts too, which ends the last slope.
        private static function countSquares(heights:int, level:int):int
        {
            return squareOf(heights - 1, level) + 1;
        }

        /** Takes the bounds of another grid with the same numbers of columns and rows. */
        public function copyFrom(other:HeightPyramid):void
        {
            for (var i:int = 0; i < _bounds.length; i++)
            {
                _bounds[i] = other._bounds[i];
            }
            findWhole();
        }

        private function findWhole():void
        {
            findRange(lastLevel, 0, 0, 0, 0, whole);
        }

        /** Finds bounds of a range of a level's squares. At level 0 they are of the heights themselves. */
        public function findRange(level:int, firstColumn:int, firstRow:int, lastColumn:int, lastRow:int, out:HeightBounds):void
        {
            if (level == 0)
            {
                findRangeOfHeights(firstColumn, firstRow, lastColumn, lastRow, out);
                return;
            }
            var stride:int = countSquares(_grid.columns, level);
            var low:Number = Infinity;
            var high:Number = -Infinity;
            out.maxStepX = out.maxStepY = 0;
            out.hasHole = false;
            out.isAllHoles = true;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = firstColumn; column <= lastColumn; column++)
                {
                    var at:int = _begins[level] + NUMBERS_PER_SQUARE * (row * stride + column);
                    low = Math.min(low, _bounds[at]);
                    high = Math.max(high, _bounds[int(at + 1)]);
                    out.maxStepX = Math.max(out.maxStepX, _bounds[int(at + 2)]);
                    out.maxStepY = Math.max(out.maxStepY, _bounds[int(at + 3)]);
                    out.hasHole ||= _bounds[int(at + 4)] > 0;
                    out.isAllHoles &&= _bounds[int(at + 4)] > 1;
                }
            }
            out.min = low;
            out.max = high;
        }

        // Finds bounds of a range of heights, all of which are read.
        private function findRangeOfHeights(firstColumn:int, firstRow:int, lastColumn:int, lastRow:int, out:HeightBounds):void
        {
            var all:Vector.<Number> = _grid.heights;
            var holes:Vector.<int> = _grid.holes;
            var columns:int = _grid.columns;
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var maxStepX:Number = 0;
            var maxStepY:Number = 0;
            out.hasHole = false;
            out.isAllHoles = true;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = firstColumn; column <= lastColumn; column++)
                {
                    var at:int = row * columns + column;
                    var here:Number = all[at];
                    low = here < low ? here : low;
                    high = here > high ? here : high;
                    var rise:Number = column == firstColumn ? 0 : here - all[int(at - 1)];
                    maxStepX = rise > maxStepX ? rise : maxStepX;
                    maxStepX = -rise > maxStepX ? -rise : maxStepX;
                    rise = row == firstRow ? 0 : here - all[int(at - columns)];
                    maxStepY = rise > maxStepY ? rise : maxStepY;
                    maxStepY = -rise > maxStepY ? -rise : maxStepY;
                    if (holes[at >> 5] != 0 && _grid.isHole(at))
                    {
                        out.hasHole = true;
                    }
                    else
                    {
                        out.isAllHoles = false;
                    }
                }
            }
            out.min = low;
            out.max = high;
            out.maxStepX = maxStepX;
            out.maxStepY = maxStepY;
        }

        /**
         * Finds bounds of the heights that the grid has in a rectangle around a place, and of how much neighbours differ. A large rectangle
         * is extended to whole squares.
         */
        public function findAround(x:Number, y:Number, halfX:Number, halfY:Number, out:HeightBounds):void
        {
            var grid:HeightGrid = _grid;
            var toX:Number = (x - grid.x) / grid.cellWidth;
            var toY:Number = (y - grid.y) / grid.cellWidth;
            // Blocks begin half a cell before their heights. A block that only touches the rectangle does not count.
            var border:Number = grid.isBlocky ? 0.5 : 0;
            var minX:Number = Math.floor(toX - halfX / grid.cellWidth + border);
            var minY:Number = Math.floor(toY - halfY / grid.cellWidth + border);
            var maxX:Number = Math.ceil(toX + halfX / grid.cellWidth - border);
            var maxY:Number = Math.ceil(toY + halfY / grid.cellWidth - border);
            // Rounding can leave nothing of a small rectangle between two blocks. Then the least is the greater one, and both count.
            var firstColumn:int = Math.max(0, Math.min(minX, maxX));
            var firstRow:int = Math.max(0, Math.min(minY, maxY));
            var lastColumn:int = Math.min(grid.columns - 1, Math.max(minX, maxX));
            var lastRow:int = Math.min(grid.rows - 1, Math.max(minY, maxY));
            var level:int = 0;
            while (level < lastLevel && (lastColumn - firstColumn > MAX_SQUARES || lastRow - firstRow > MAX_SQUARES))
            {
                firstColumn >>= SHIFT;
                firstRow >>= SHIFT;
                lastColumn >>= SHIFT;
                lastRow >>= SHIFT;
                level++;
            }
            findRange(level, firstColumn, firstRow, lastColumn, lastRow, out);
        }

        /** Computes the bounds of all squares to which a range of heights belongs. Call it after a change of these heights or holes. */
        public function update(firstColumn:int, firstRow:int, lastColumn:int, lastRow:int):void
        {
            for (var level:int = 1; level <= lastLevel; level++)
            {
                // the heights around a square count for the squares of level 1, and so for those above
                var overlap:int = level == 1 ? 1 : 0;
                firstColumn = Math.max(0, firstColumn - overlap) >> SHIFT;
                firstRow = Math.max(0, firstRow - overlap) >> SHIFT;
                lastColumn = Math.min(countSquares(_grid.columns, level - 1) - 1, lastColumn + overlap) >> SHIFT;
                lastRow = Math.min(countSquares(_grid.rows, level - 1) - 1, lastRow + overlap) >> SHIFT;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    for (var column:int = firstColumn; column <= lastColumn; column++)
                    {
                        updateSquare(level, column, row, overlap);
                    }
                }
            }
            findWhole();
        }

        // Computes the bounds of a square from the bounds of its squares of the level below, and of some rows and columns around these.
        private function updateSquare(level:int, column:int, row:int, overlap:int):void
        {
            var firstColumn:int = Math.max(0, (column << SHIFT) - overlap);
            var firstRow:int = Math.max(0, (row << SHIFT) - overlap);
            var lastColumn:int = Math.min(countSquares(_grid.columns, level - 1), ((column + 1) << SHIFT) + overlap) - 1;
            var lastRow:int = Math.min(countSquares(_grid.rows, level - 1), ((row + 1) << SHIFT) + overlap) - 1;
            findRange(level - 1, firstColumn, firstRow, lastColumn, lastRow, _range);
            var at:int = _begins[level] + NUMBERS_PER_SQUARE * (row * countSquares(_grid.columns, level) + column);
            _bounds[at] = _range.min;
            _bounds[int(at + 1)] = _range.max;
            _bounds[int(at + 2)] = _range.maxStepX;
            _bounds[int(at + 3)] = _range.maxStepY;
            _bounds[int(at + 4)] = int(_range.hasHole) + int(_range.isAllHoles);
        }
    }
}
