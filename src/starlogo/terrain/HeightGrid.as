package starlogo.terrain
{
    /**
     * The heights of a terrain, with bounds for blocks of cells. Tests skip the blocks that are far above or below. It has plain fields,
     * because all tests of the ground read them, and V8 allocates an object for each Number that is passed.
     *
     * @private
     */
    public final class HeightGrid
    {
        /** How many cells a block is wide, as a shift. */
        public static const BLOCK:int = 3;

        /** How many heights there are along x. */
        public var columns:int;

        /** How many there are along y. */
        public var rows:int;

        /** How far neighbours are apart. */
        public var cellWidth:Number;

        /** Where the first height is. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** Whether the surface is upright columns; otherwise it is slopes. */
        public var isBlocky:Boolean = false;

        /** The heights, row by row. */
        public var heights:Vector.<Number>;

        /** How many blocks there are in a row. */
        public var blockColumns:int;

        /** For each block, row by row: the least height of its cells' corners, and of the neighbours that its walls lead to. */
        public var leasts:Vector.<Number>;

        /** For each block: the greatest of these heights. */
        public var greatests:Vector.<Number>;

        /** For each block: the square of the steepest slope of its cells. */
        public var steepests:Vector.<Number>;

        /** Tests models against the ground. It is here, so that a bundle without a Terrain has none of these tests. */
        public var pair:TerrainPair = new TerrainPair();

        /** Decides quickly about shapes that are clearly above or in the ground. */
        public var look:QuickLook = new QuickLook();

        /** Finds where rays meet the ground. */
        public var rays:GroundRay = new GroundRay();

        /** How often heights have changed. */
        public var revision:int = 0;

        /** The place for <code>findHeight()</code>. */
        public var placeX:Number = 0;

        /** @copy #placeX */
        public var placeY:Number = 0;

        /** How high the ground is at the place; NaN outside. */
        public var height:Number = 0;

        // A variable and not the constant, because V8 allocates an object for the next Number that is written after the constant.
        private var _nothing:Number = NaN;

        // The greatest of all heights; NaN if it has to be found anew.
        private var _greatest:Number = NaN;

        /** Creates flat ground. The caller has checked the numbers. */
        public function HeightGrid(columns:int, rows:int, cellWidth:Number, x:Number, y:Number)
        {
            this.columns = columns;
            this.rows = rows;
            this.cellWidth = cellWidth;
            this.x = x;
            this.y = y;
            blockColumns = ((columns - 1) >> BLOCK) + 1;
            heights = new Vector.<Number>(columns * rows, true);
            leasts = new Vector.<Number>(blockColumns * (((rows - 1) >> BLOCK) + 1), true);
            greatests = new Vector.<Number>(leasts.length, true);
            steepests = new Vector.<Number>(leasts.length, true);
            reset();
        }

        /** Makes all heights 0. */
        public function reset():void
        {
            revision++;
            clear(heights);
            clear(leasts);
            clear(greatests);
            clear(steepests);
            _greatest = 0;
        }

        /** The greatest of all heights. */
        public function get greatest():Number
        {
            if (isNaN(_greatest))
            {
                _greatest = greatests[0];
                for (var i:int = 1; i < greatests.length; i++)
                {
                    _greatest = Math.max(_greatest, greatests[i]);
                }
            }
            return _greatest;
        }

        /** Finds the height at the place. */
        public function findHeight():void
        {
            var toX:Number = (placeX - x) / cellWidth;
            var toY:Number = (placeY - y) / cellWidth;
            if (isBlocky)
            {
                findTop();
                return;
            }
            if (!(toX >= 0 && toY >= 0 && toX <= columns - 1 && toY <= rows - 1))
            {
                height = _nothing;
                return;
            }
            // The conversion to int rounds down, because the numbers are not negative.
            var column:int = toX;
            var row:int = toY;
            column = column < columns - 1 ? column : column - 1;
            row = row < rows - 1 ? row : row - 1;
            toX -= column;
            toY -= row;
            var corner:int = row * columns + column;
            if (toX >= toY)
            {
                height = (1 - toX) * heights[corner] + (toX - toY) * heights[int(corner + 1)] + toY * heights[int(corner + columns + 1)];
            }
            else
            {
                height = (1 - toY) * heights[corner] + (toY - toX) * heights[int(corner + columns)] + toX * heights[int(corner + columns + 1)];
            }
        }

        /** Computes the bounds of the blocks that contain a range of heights, and of the blocks whose cells end there. */
        public function findBounds(first:int, firstRow:int, last:int, lastRow:int):void
        {
            revision++;
            _greatest = NaN;
            for (var blockRow:int = Math.max(0, firstRow - 1) >> BLOCK; blockRow <= lastRow >> BLOCK; blockRow++)
            {
                for (var blockColumn:int = Math.max(0, first - 1) >> BLOCK; blockColumn <= last >> BLOCK; blockColumn++)
                {
                    findBoundsOf(blockColumn, blockRow);
                }
            }
        }

        private function findBoundsOf(blockColumn:int, blockRow:int):void
        {
            var least:Number = Infinity;
            var greatestHere:Number = -Infinity;
            var steepest:Number = 0;
            var end:int = Math.min(columns - 1, (blockColumn + 1) << BLOCK);
            var endRow:int = Math.min(rows - 1, (blockRow + 1) << BLOCK);
            for (var row:int = blockRow << BLOCK; row <= endRow; row++)
            {
                for (var column:int = blockColumn << BLOCK; column <= end; column++)
                {
                    var at:int = row * columns + column;
                    var corner:Number = heights[at];
                    least = corner < least ? corner : least;
                    greatestHere = corner > greatestHere ? corner : greatestHere;
                    if (column < end && row < endRow)
                    {
                        var far:Number = heights[int(at + columns + 1)];
                        var x1:Number = heights[int(at + 1)] - corner;
                        var y1:Number = far - heights[int(at + 1)];
                        var x2:Number = far - heights[int(at + columns)];
                        var y2:Number = heights[int(at + columns)] - corner;
                        steepest = Math.max(steepest, Math.max(x1 * x1 + y1 * y1, x2 * x2 + y2 * y2));
                    }
                }
            }
            var block:int = blockRow * blockColumns + blockColumn;
            leasts[block] = least;
            greatests[block] = greatestHere;
            steepests[block] = steepest / cellWidth / cellWidth;
        }

        // Finds the height at the place on a surface of columns.
        private function findTop():void
        {
            var toX:Number = (placeX - x) / cellWidth + 0.5;
            var toY:Number = (placeY - y) / cellWidth + 0.5;
            if (!(toX >= 0 && toY >= 0 && toX <= columns && toY <= rows))
            {
                height = _nothing;
                return;
            }
            var column:int = toX;
            var row:int = toY;
            var before:int = column == toX && column > 0 ? column - 1 : column;
            var rowBefore:int = row == toY && row > 0 ? row - 1 : row;
            column = column < columns ? column : before;
            row = row < rows ? row : rowBefore;
            height = heights[int(row * columns + column)];
            if (before != column || rowBefore != row)
            {
                height = Math.max(height, heights[int(row * columns + before)]);
                height = Math.max(height, heights[int(rowBefore * columns + column)]);
                height = Math.max(height, heights[int(rowBefore * columns + before)]);
            }
        }

        private static function clear(numbers:Vector.<Number>):void
        {
            for (var i:int = 0; i < numbers.length; i++)
            {
                numbers[i] = 0;
            }
        }
    }
}
