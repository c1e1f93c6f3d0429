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

        // A range is not read height by height if it is longer than this, along x or along y.
        private static const MOST_SQUARES:int = 16;

        // The list of the first member, and the list of the first row.
        private static const FIRST:Vector.<int> = new <int>[0];

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

        /** The last level. */
        public var levels:int = 0;

        /** Tests models against the ground. It is here, so that a bundle without a Terrain has none of these tests. */
        public var pair:TerrainPair = new TerrainPair();

        /** Decides quickly about shapes that are clearly above or in the ground. */
        public var look:QuickLook = new QuickLook();

        /** Finds where rays meet the ground. */
        public var rays:GroundRay = new GroundRay();

        /** Whether a frame needs <code>heights</code> and <code>bounds</code> as they are. Then the next change makes new lists. */
        public var isHeld:Boolean = false;

        /** How often the surface has changed. */
        public var revision:int = 0;

        /** The place for <code>findHeight()</code>. */
        public var placeX:Number = 0;

        /** @copy #placeX */
        public var placeY:Number = 0;

        /** The place for <code>isOver()</code> has this height, and the ground is moved in by the inset. */
        public var placeZ:Number = 0;

        /** @copy #placeZ */
        public var inset:Number = 0;

        /** How far from the place <code>findAround()</code> looks. */
        public var reachX:Number = 0;

        /** @copy #reachX */
        public var reachY:Number = 0;

        /** How high the ground is at the place; NaN outside. */
        public var height:Number = 0;

        /** How far sloping ground at the place falls from a height to the next one along x. */
        public var fallX:Number = 0;

        /** How far it falls along y. */
        public var fallY:Number = 0;

        /** The greatest height that <code>findRange()</code> has found, and the least one. */
        public var greatest:Number = 0;

        /** @copy #greatest */
        public var least:Number = 0;

        /** The greatest difference of two neighbours along x that <code>findRange()</code> has found, and the one along y. */
        public var stepX:Number = 0;

        /** @copy #stepX */
        public var stepY:Number = 0;

        // The triangles of places: see findCorners.
        private var _corners:Vector.<int> = new <int>[0];
        private var _sides:Vector.<int> = new <int>[0];
        private var _mores:Vector.<Number> = new <Number>[0];
        private var _lesses:Vector.<Number> = new <Number>[0];

        // A list with one place.
        private var _placeX:Vector.<Number> = new <Number>[0];
        private var _placeY:Vector.<Number> = new <Number>[0];
        private var _found:Vector.<Number> = new <Number>[0];

        /** Creates flat ground. The caller has checked the numbers. */
        public function HeightGrid(columns:int, rows:int, cellWidth:Number, x:Number, y:Number)
        {
            this.columns = columns;
            this.rows = rows;
            this.cellWidth = cellWidth;
            this.x = x;
            this.y = y;
            var size:int = 0;
            while (countSquares(columns, levels) > 1 || countSquares(rows, levels) > 1)
            {
                levels++;
                begins.push(size);
                size += 3 * countSquares(columns, levels) * countSquares(rows, levels);
            }
            bounds = new Vector.<Number>(size, true);
            reset();
        }

        /** How many squares of a level there are along a row or a column with this many heights. */
        public static function countSquares(heights:int, level:int):int
        {
            return ((heights - 1) >> (level * SHIFT)) + 1;
        }

        /** Makes all heights 0. */
        public function reset():void
        {
            revision++;
            heights = new Vector.<Number>(columns * rows, true);
            bounds = new Vector.<Number>(bounds.length, true);
        }

        /** Call it before a change of some heights. */
        public function beginChange():void
        {
            if (isHeld)
            {
                heights = heights.concat();
                bounds = bounds.concat();
                isHeld = false;
            }
        }

        /** Finds the height at the place. */
        public function findHeight():void
        {
            _placeX[0] = placeX;
            _placeY[0] = placeY;
            findHeights(_placeX, _placeY, FIRST, FIRST, 1, _found);
            height = _found[0];
        }

        /**
         * Whether the ground is higher than the place. With an inset the ground is narrower: it must be higher at the four places that are the
         * inset beside it along x and y.
         */
        public function isOver():Boolean
        {
            var atX:Number = placeX;
            var atY:Number = placeY;
            for (var side:int = inset > 0 ? 0 : 3; side < 4; side++)
            {
                var toX:Number = (side & 1) == 0 ? -inset : inset;
                var toY:Number = (side & 2) == 0 ? -inset : inset;
                placeX = atX + toX;
                placeY = atY + toY;
                findHeight();
                if (!(height - inset >= placeZ))
                {
                    return false;
                }
            }
            return true;
        }

        /** Finds the fall of sloping ground at the place. <code>findHeight()</code> comes before. */
        public function findFall():void
        {
            var near:Number = heights[_corners[0]];
            var side:Number = heights[_sides[0]];
            var far:Number = heights[int(_corners[0] + columns + 1)];
            var isRight:Boolean = _sides[0] == _corners[0] + 1;
            fallX = isRight ? near - side : side - far;
            fallY = isRight ? side - far : near - side;
        }

        /**
         * Finds the heights at the places of members of a list.
         *
         * @param xs the places, by row
         * @param rows the row of each member
         * @param members the list
         * @param count its length
         * @param out receives the heights, in the order of the list
         */
        public function findHeights(xs:Vector.<Number>, ys:Vector.<Number>, rows:Vector.<int>, members:Vector.<int>, count:int, out:Vector.<Number>):void
        {
            if (isBlocky)
            {
                findTops(xs, ys, rows, members, count, out);
                return;
            }
            findCorners(xs, ys, rows, members, count);
            // This loop is short, so the processor waits for the heights of several places at once.
            var all:Vector.<Number> = heights;
            var corners:Vector.<int> = _corners;
            var sides:Vector.<int> = _sides;
            var mores:Vector.<Number> = _mores;
            var lesses:Vector.<Number> = _lesses;
            var toFar:int = columns + 1;
            for (var i:int = 0; i < count; i++)
            {
                var corner:int = corners[i];
                var more:Number = mores[i];
                var less:Number = lesses[i];
                out[i] = (1 - more) * all[corner] + (more - less) * all[sides[i]] + less * all[int(corner + toFar)];
            }
        }

        // Finds the triangles of places: the corner of the cell with the least x and y, the corner beside the diagonal, and the place in the
        // cell. The shares of a place outside are NaN.
        private function findCorners(xs:Vector.<Number>, ys:Vector.<Number>, rows:Vector.<int>, members:Vector.<int>, count:int):void
        {
            var lastColumn:int = columns - 1;
            var lastRow:int = this.rows - 1;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = rows[members[i]];
                var toX:Number = (xs[at] - x) / cellWidth;
                var toY:Number = (ys[at] - y) / cellWidth;
                if (!(toX >= 0 && toY >= 0 && toX <= lastColumn && toY <= lastRow))
                {
                    _corners[i] = _sides[i] = 0;
                    _mores[i] = _lesses[i] = NaN;
                    continue;
                }
                // The conversion to int rounds down, because the numbers are not negative.
                var column:int = toX;
                var row:int = toY;
                if (column == lastColumn)
                {
                    column--;
                }
                if (row == lastRow)
                {
                    row--;
                }
                toX -= column;
                toY -= row;
                var corner:int = row * columns + column;
                var isRight:Boolean = toX >= toY;
                _corners[i] = corner;
                _sides[i] = isRight ? corner + 1 : corner + columns;
                _mores[i] = isRight ? toX : toY;
                _lesses[i] = isRight ? toY : toX;
            }
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
                last = Math.min(countSquares(columns, level - 1) - 1, last + around) >> SHIFT;
                lastRow = Math.min(countSquares(rows, level - 1) - 1, lastRow + around) >> SHIFT;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    for (var column:int = first; column <= last; column++)
                    {
                        findBoundsOf(level, column, row, around);
                    }
                }
            }
        }

        /** Finds the least and the greatest height of a range, and how much neighbours differ. */
        public function findRange(first:int, firstRow:int, last:int, lastRow:int):void
        {
            var all:Vector.<Number> = heights;
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var alongX:Number = 0;
            var alongY:Number = 0;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = first; column <= last; column++)
                {
                    var at:int = row * columns + column;
                    var here:Number = all[at];
                    low = here < low ? here : low;
                    high = here > high ? here : high;
                    var step:Number = column == first ? 0 : here - all[int(at - 1)];
                    alongX = step > alongX ? step : alongX;
                    alongX = -step > alongX ? -step : alongX;
                    step = row == firstRow ? 0 : here - all[int(at - columns)];
                    alongY = step > alongY ? step : alongY;
                    alongY = -step > alongY ? -step : alongY;
                }
            }
            least = low;
            greatest = high;
            stepX = alongX;
            stepY = alongY;
        }

        /**
         * Finds bounds of the heights that the ground has within the reach of the place along x and y, and of how much neighbours differ. A large
         * range is extended to whole squares. Without ground there, the greatest is -Infinity.
         */
        public function findAround():void
        {
            var border:Number = isBlocky ? 0.5 : 0;
            var toX:Number = (placeX - x) / cellWidth;
            var toY:Number = (placeY - y) / cellWidth;
            var first:int = Math.max(0, Math.floor(toX - reachX / cellWidth + border));
            var firstRow:int = Math.max(0, Math.floor(toY - reachY / cellWidth + border));
            var last:int = Math.min(columns - 1, Math.ceil(toX + reachX / cellWidth - border));
            var lastRow:int = Math.min(rows - 1, Math.ceil(toY + reachY / cellWidth - border));
            var level:int = 0;
            while (level < levels && (last - first > MOST_SQUARES || lastRow - firstRow > MOST_SQUARES))
            {
                first >>= SHIFT;
                firstRow >>= SHIFT;
                last >>= SHIFT;
                lastRow >>= SHIFT;
                level++;
            }
            if (level == 0)
            {
                findRange(first, firstRow, last, lastRow);
                return;
            }
            joinBounds(begins[level], countSquares(columns, level), first, firstRow, last, lastRow);
            stepY = stepX;
        }

        // Computes the bounds of a square from the squares of the level before, or from the heights. Some rows and columns around count too.
        private function findBoundsOf(level:int, column:int, row:int, around:int):void
        {
            var stride:int = countSquares(columns, level - 1);
            var first:int = Math.max(0, (column << SHIFT) - around);
            var firstRow:int = Math.max(0, (row << SHIFT) - around);
            var last:int = Math.min(stride, ((column + 1) << SHIFT) + around) - 1;
            var lastRow:int = Math.min(countSquares(rows, level - 1), ((row + 1) << SHIFT) + around) - 1;
            if (level == 1)
            {
                findRange(first, firstRow, last, lastRow);
            }
            else
            {
                joinBounds(begins[level - 1], stride, first, firstRow, last, lastRow);
            }
            var at:int = begins[level] + 3 * (row * countSquares(columns, level) + column);
            bounds[at] = least;
            bounds[int(at + 1)] = greatest;
            bounds[int(at + 2)] = Math.max(stepX, stepY);
        }

        // Like findRange, from the bounds of squares.
        private function joinBounds(begin:int, stride:int, first:int, firstRow:int, last:int, lastRow:int):void
        {
            least = Infinity;
            greatest = -Infinity;
            stepX = stepY = 0;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = first; column <= last; column++)
                {
                    var at:int = begin + 3 * (row * stride + column);
                    least = Math.min(least, bounds[at]);
                    greatest = Math.max(greatest, bounds[int(at + 1)]);
                    stepX = Math.max(stepX, bounds[int(at + 2)]);
                }
            }
        }

        // Finds the heights of columns. Where columns meet, it is the highest.
        private function findTops(xs:Vector.<Number>, ys:Vector.<Number>, rows:Vector.<int>, members:Vector.<int>, count:int, out:Vector.<Number>):void
        {
            for (var i:int = 0; i < count; i++)
            {
                var at:int = rows[members[i]];
                // in cells, from the outer corner of the first column
                var toX:Number = (xs[at] - x) / cellWidth + 0.5;
                var toY:Number = (ys[at] - y) / cellWidth + 0.5;
                out[i] = NaN;
                if (toX >= 0 && toY >= 0 && toX <= columns && toY <= this.rows)
                {
                    findRange(Math.max(0, Math.ceil(toX) - 1), Math.max(0, Math.ceil(toY) - 1), Math.min(toX, columns - 1), Math.min(toY, this.rows - 1));
                    out[i] = greatest;
                }
            }
        }
    }
}
