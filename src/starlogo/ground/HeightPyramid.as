package starlogo.ground
{
    /**
     * Bounds of the heights of a grid, for squares of its cells: the least height, the greatest height, and how much neighbours differ. A square of
     * level 1 is 8 cells wide, and a square of each next level is 8 squares wide. The last level is one square.
     *
     * <p>The heights and the holes around a square count too, because walls lead to them.</p>
     *
     * @private
     */
    public final class HeightPyramid
    {
        /** How many squares of a level a square of the next level is wide, as a shift. */
        public static const SHIFT:int = 3;

        // For each square: the least height, the greatest height, the greatest difference of two heights that are neighbours along x or y, and 1 if a
        // cell there is a hole, or 0.
        private static const NUMBERS:int = 4;

        /** The number of the last level. Level 0 is the cells, whose heights need no bounds. */
        public var lastLevel:int = 0;

        private var _columns:int;
        private var _rows:int;

        // The numbers of all squares, level by level and row by row; and by level, where its squares begin.
        private var _bounds:Vector.<Number>;
        private var _begins:Vector.<int> = new <int>[0];

        private var _range:HeightRange = new HeightRange();

        /**
         * Bounds of heights that are 0.
         *
         * @param columns how many heights there are along x
         * @param rows how many there are along y
         */
        public function HeightPyramid(columns:int, rows:int)
        {
            var size:int = 0;
            _columns = columns;
            _rows = rows;
            while (countSquares(columns, lastLevel) > 1 || countSquares(rows, lastLevel) > 1)
            {
                lastLevel++;
                _begins.push(size);
                size += NUMBERS * countSquares(columns, lastLevel) * countSquares(rows, lastLevel);
            }
            _bounds = new Vector.<Number>(size, true);
        }

        // How many squares of a level there are along a row or a column with this many heights.
        private static function countSquares(heights:int, level:int):int
        {
            return ((heights - 1) >> (level * SHIFT)) + 1;
        }

        /** Takes the bounds of another grid with as many columns and rows. */
        public function copyFrom(other:HeightPyramid):void
        {
            for (var i:int = 0; i < _bounds.length; i++)
            {
                _bounds[i] = other._bounds[i];
            }
        }

        /** Finds bounds of all heights. */
        public function findWhole(out:HeightRange):void
        {
            findRange(lastLevel, 0, 0, 0, 0, out);
        }

        /** Finds bounds of a range of squares. The level is at least 1. */
        public function findRange(level:int, firstColumn:int, firstRow:int, lastColumn:int, lastRow:int, out:HeightRange):void
        {
            var stride:int = countSquares(_columns, level);
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var step:Number = 0;
            out.hasHole = false;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = firstColumn; column <= lastColumn; column++)
                {
                    var at:int = _begins[level] + NUMBERS * (row * stride + column);
                    low = Math.min(low, _bounds[at]);
                    high = Math.max(high, _bounds[int(at + 1)]);
                    step = Math.max(step, _bounds[int(at + 2)]);
                    out.hasHole ||= _bounds[int(at + 3)] > 0;
                }
            }
            out.least = low;
            out.greatest = high;
            out.stepX = out.stepY = step;
        }

        /** Computes the bounds of all squares to which a range of a grid's heights belongs. */
        public function update(grid:HeightGrid, firstColumn:int, firstRow:int, lastColumn:int, lastRow:int):void
        {
            for (var level:int = 1; level <= lastLevel; level++)
            {
                var around:int = level == 1 ? 1 : 0;
                firstColumn = Math.max(0, firstColumn - around) >> SHIFT;
                firstRow = Math.max(0, firstRow - around) >> SHIFT;
                lastColumn = Math.min(countSquares(_columns, level - 1) - 1, lastColumn + around) >> SHIFT;
                lastRow = Math.min(countSquares(_rows, level - 1) - 1, lastRow + around) >> SHIFT;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    for (var column:int = firstColumn; column <= lastColumn; column++)
                    {
                        updateSquare(grid, level, column, row, around);
                    }
                }
            }
        }

        // Computes the bounds of a square from those of the level below, and of some rows and columns around.
        private function updateSquare(grid:HeightGrid, level:int, column:int, row:int, around:int):void
        {
            var firstColumn:int = Math.max(0, (column << SHIFT) - around);
            var firstRow:int = Math.max(0, (row << SHIFT) - around);
            var lastColumn:int = Math.min(countSquares(_columns, level - 1), ((column + 1) << SHIFT) + around) - 1;
            var lastRow:int = Math.min(countSquares(_rows, level - 1), ((row + 1) << SHIFT) + around) - 1;
            grid.findRange(level - 1, firstColumn, firstRow, lastColumn, lastRow, _range);
            var at:int = _begins[level] + NUMBERS * (row * countSquares(_columns, level) + column);
            _bounds[at] = _range.least;
            _bounds[int(at + 1)] = _range.greatest;
            _bounds[int(at + 2)] = Math.max(_range.stepX, _range.stepY);
            _bounds[int(at + 3)] = int(_range.hasHole);
        }
    }
}
