package starlogo.terrain
{
    /**
     * The heights of a terrain, with bounds for squares of cells. Tests skip the squares that are far above or below. It has plain fields,
     * because all tests of the ground read them, and V8 allocates an object for each Number that is passed.
     *
     * @private
     */
    public final class HeightGrid
    {
        /** How many squares of a level a square of the next level is wide, as a shift. */
        public static const SHIFT:int = 3;

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

        /**
         * Three numbers for each square of cells: the least height there, the greatest height, and the greatest difference of two heights that
         * are neighbours along x or y. A square of level 1 is 8 cells wide, and a square of each next level is 8 squares wide. The last level is
         * one square. The heights around a square count too, because walls lead to them.
         */
        public var bounds:Vector.<Number>;

        /** By level: where its squares begin in <code>bounds</code>. Level 0 is the heights, which have no bounds. */
        public var begins:Vector.<int> = new <int>[0];

        /** By level: how many squares there are in a row. */
        public var across:Vector.<int>;

        /** By level: how many rows there are. */
        public var down:Vector.<int>;

        /** By level: how wide a square is. */
        public var widths:Vector.<Number>;

        /** The last level. */
        public var levels:int = 0;

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

        /** How far sloping ground at the place falls from a height to the next one along x. */
        public var fallX:Number = 0;

        /** How far it falls along y. */
        public var fallY:Number = 0;

        // A variable and not the constant, because V8 allocates an object for the next Number that is written after the constant.
        private var _nothing:Number = NaN;

        /** Creates flat ground. The caller has checked the numbers. */
        public function HeightGrid(columns:int, rows:int, cellWidth:Number, x:Number, y:Number)
        {
            this.columns = columns;
            this.rows = rows;
            this.cellWidth = cellWidth;
            this.x = x;
            this.y = y;
            across = new <int>[columns];
            down = new <int>[rows];
            widths = new <Number>[cellWidth];
            var size:int = 0;
            while (across[levels] > 1 || down[levels] > 1)
            {
                across.push(((across[levels] - 1) >> SHIFT) + 1);
                down.push(((down[levels] - 1) >> SHIFT) + 1);
                widths.push(widths[levels] * (1 << SHIFT));
                levels++;
                begins.push(size);
                size += 3 * across[levels] * down[levels];
            }
            bounds = new Vector.<Number>(size, true);
            reset();
        }

        /** Makes all heights 0. */
        public function reset():void
        {
            revision++;
            heights = new Vector.<Number>(columns * rows, true);
            bounds = new Vector.<Number>(bounds.length, true);
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
            var column:int = Math.min(toX, columns - 2);
            var row:int = Math.min(toY, rows - 2);
            toX -= column;
            toY -= row;
            var corner:int = row * columns + column;
            var isRight:Boolean = toX >= toY;
            var more:Number = isRight ? toX : toY;
            var less:Number = isRight ? toY : toX;
            var near:Number = heights[corner];
            var beside:int = isRight ? corner + 1 : corner + columns;
            var side:Number = heights[beside];
            var far:Number = heights[int(corner + columns + 1)];
            height = (1 - more) * near + (more - less) * side + less * far;
            fallX = isRight ? near - side : side - far;
            fallY = isRight ? side - far : near - side;
        }

        /** Computes the bounds of all squares to which a range of heights belongs. */
        public function findBounds(first:int, firstRow:int, last:int, lastRow:int):void
        {
            revision++;
            for (var level:int = 1; level <= levels; level++)
            {
                var around:int = level == 1 ? 1 : 0;
                first = Math.max(0, first - around) >> SHIFT;
                firstRow = Math.max(0, firstRow - around) >> SHIFT;
                last = Math.min(across[level - 1] - 1, last + around) >> SHIFT;
                lastRow = Math.min(down[level - 1] - 1, lastRow + around) >> SHIFT;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    for (var column:int = first; column <= last; column++)
                    {
                        findBoundsOf(level, column, row, around);
                    }
                }
            }
        }

        // Computes the bounds of a square from the squares of the level before, or from the heights. Some rows and columns around count too.
        private function findBoundsOf(level:int, column:int, row:int, around:int):void
        {
            var least:Number = Infinity;
            var greatest:Number = -Infinity;
            var difference:Number = 0;
            var stride:int = across[level - 1];
            var first:int = Math.max(0, (column << SHIFT) - around);
            var firstRow:int = Math.max(0, (row << SHIFT) - around);
            var end:int = Math.min(stride, ((column + 1) << SHIFT) + around);
            var endRow:int = Math.min(down[level - 1], ((row + 1) << SHIFT) + around);
            for (var i:int = firstRow; i < endRow; i++)
            {
                for (var j:int = first; j < end; j++)
                {
                    var at:int = i * stride + j;
                    if (level == 1)
                    {
                        var here:Number = heights[at];
                        least = here < least ? here : least;
                        greatest = here > greatest ? here : greatest;
                        var alongX:Number = j == first ? 0 : here - heights[int(at - 1)];
                        var alongY:Number = i == firstRow ? 0 : here - heights[int(at - columns)];
                        difference = alongX > difference ? alongX : difference;
                        difference = alongY > difference ? alongY : difference;
                        difference = -alongX > difference ? -alongX : difference;
                        difference = -alongY > difference ? -alongY : difference;
                    }
                    else
                    {
                        at = begins[level - 1] + 3 * at;
                        least = Math.min(least, bounds[at]);
                        greatest = Math.max(greatest, bounds[int(at + 1)]);
                        difference = Math.max(difference, bounds[int(at + 2)]);
                    }
                }
            }
            at = begins[level] + 3 * (row * across[level] + column);
            bounds[at] = least;
            bounds[int(at + 1)] = greatest;
            bounds[int(at + 2)] = difference;
        }

        // Finds the height at the place on a surface of columns. Where columns meet, it is the highest.
        private function findTop():void
        {
            var toX:Number = (placeX - x) / cellWidth + 0.5;
            var toY:Number = (placeY - y) / cellWidth + 0.5;
            if (!(toX >= 0 && toY >= 0 && toX <= columns && toY <= rows))
            {
                height = _nothing;
                return;
            }
            var column:int = Math.min(toX, columns - 1);
            var row:int = Math.min(toY, rows - 1);
            var before:int = Math.max(0, Math.ceil(toX) - 1);
            var below:int = columns * Math.max(0, Math.ceil(toY) - 1);
            row *= columns;
            height = Math.max(Math.max(heights[int(row + column)], heights[int(row + before)]), Math.max(heights[int(below + column)], heights[int(below + before)]));
        }
    }
}
