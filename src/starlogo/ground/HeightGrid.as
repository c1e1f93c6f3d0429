package starlogo.ground
{
    /**
     * The heights of a terrain, with bounds for squares of cells: how high the ground is at a place, and between which heights it is around
     * one. GroundTriangles makes its triangles, which GroundPair tests with bodies and GroundRay with rays; GroundEarlyOut answers before
     * that from a few heights. Read this class first, then GroundTriangles.
     *
     * <p>Questions write to records, because V8 allocates an object for each Number that is passed or returned.</p>
     *
     * @private
     */
    public final class HeightGrid
    {
        /** How many squares of a level a square of the next level is wide, as a shift. */
        public static const SHIFT:int = 3;

        // A range is not read height by height if it is longer than this, along x or along y.
        private static const MOST_SQUARES:int = 16;

        /** How many heights there are along x. */
        public var columns:int;

        /** How many there are along y. */
        public var rows:int;

        /** How far neighbours are apart. */
        public var cellWidth:Number;

        /** Where the first height is. */
        public var x:Number;
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

        /** The number of the last level. */
        public var levels:int = 0;

        /** Whether a frame needs <code>heights</code> and <code>bounds</code> as they are. Then the next change makes new lists. */
        public var isHeld:Boolean = false;

        /** How often the surface has changed. */
        public var revision:int = 0;

        private var _range:HeightRange = new HeightRange();
        private var _point:GroundPoint = new GroundPoint();

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

        /** Makes another grid the same ground, or makes a new one. The two share their lists. */
        public function copyInto(other:HeightGrid):HeightGrid
        {
            other ||= new HeightGrid(2, 2, 1, 0, 0);
            other.columns = columns;
            other.rows = rows;
            other.cellWidth = cellWidth;
            other.x = x;
            other.y = y;
            other.isBlocky = isBlocky;
            other.heights = heights;
            other.bounds = bounds;
            other.begins = begins;
            other.levels = levels;
            return other;
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

        /** Whether a place is between the first height and the last, or at most this far outside along x and y. */
        public function isWithin(atX:Number, atY:Number, border:Number):Boolean
        {
            return atX >= x - border && atY >= y - border && atX <= x + (columns - 1) * cellWidth + border && atY <= y + (rows - 1) * cellWidth + border;
        }

        /** The height at a place; NaN outside. Where columns meet, it is the height of the highest. */
        public function heightAt(atX:Number, atY:Number):Number
        {
            _point.x = atX;
            _point.y = atY;
            findHeight(_point);
            return _point.height;
        }

        /** Finds the height at a point's x and y, and its triangle. */
        public function findHeight(at:GroundPoint):void
        {
            // Slopes are between heights. Columns begin half a cell before their heights.
            if (!isWithin(at.x, at.y, isBlocky ? cellWidth / 2 : 0))
            {
                at.height = NaN;
                return;
            }
            var toX:Number = (at.x - x) / cellWidth;
            var toY:Number = (at.y - y) / cellWidth;
            if (isBlocky)
            {
                // rounding can lead beyond the last column
                toX = Math.min(toX + 0.5, columns);
                toY = Math.min(toY + 0.5, rows);
                findRange(0, Math.max(0, Math.ceil(toX) - 1), Math.max(0, Math.ceil(toY) - 1), Math.min(toX, columns - 1), Math.min(toY, rows - 1), _range);
                at.height = _range.greatest;
                return;
            }
            // The conversion to int rounds down, because the numbers are not negative.
            var column:int = Math.min(toX, columns - 2);
            var row:int = Math.min(toY, rows - 2);
            toX -= column;
            toY -= row;
            var corner:int = row * columns + column;
            at.corner = corner;
            at.side = toX >= toY ? corner + 1 : corner + columns;
            var more:Number = toX >= toY ? toX : toY;
            var less:Number = toX >= toY ? toY : toX;
            at.height = (1 - more) * heights[corner] + (more - less) * heights[at.side] + less * heights[int(corner + columns + 1)];
        }

        /** Finds the fall of sloping ground at a point whose triangle is known. */
        public function findFall(at:GroundPoint):void
        {
            var near:Number = heights[at.corner];
            var side:Number = heights[at.side];
            var far:Number = heights[int(at.corner + columns + 1)];
            var isRight:Boolean = at.side == at.corner + 1;
            at.fallX = isRight ? near - side : side - far;
            at.fallY = isRight ? side - far : near - side;
        }

        /** Moves a point to the grid's nearest point, as seen from above, and finds the height there. */
        public function findNearest(at:GroundPoint):void
        {
            var column:int = Math.max(0, Math.min(columns - 1, Math.round((at.x - x) / cellWidth)));
            var row:int = Math.max(0, Math.min(rows - 1, Math.round((at.y - y) / cellWidth)));
            at.x = x + column * cellWidth;
            at.y = y + row * cellWidth;
            at.height = heights[int(row * columns + column)];
        }

        /** A lower bound for the length of each way out of the ground from a place, if it is shorter than the reach; 0 if none is known. */
        public function leastWayOut(atX:Number, atY:Number, atZ:Number, reach:Number):Number
        {
            var high:Number = heightAt(atX, atY);
            var border:Number = isBlocky ? cellWidth / 2 : 0;
            if (!(high > atZ) || !isWithin(atX, atY, border - reach))
            {
                return 0;
            }
            findAround(atX, atY, reach, reach, _range);
            var least:Number = _range.least - atZ;
            if (isBlocky)
            {
                return least;
            }
            var slopeX:Number = _range.stepX / cellWidth;
            var slopeY:Number = _range.stepY / cellWidth;
            return Math.max(least, (high - atZ) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY));
        }

        /** Computes the bounds of all squares to which a range of heights belongs. */
        public function findBounds(first:int, firstRow:int, last:int, lastRow:int):void
        {
            revision++;
            for (var level:int = 1; level <= levels; level++)
            {
                var around:int = level == 1 ? 1 : 0;
                var stride:int = countSquares(columns, level - 1);
                var lines:int = countSquares(rows, level - 1);
                first = Math.max(0, first - around) >> SHIFT;
                firstRow = Math.max(0, firstRow - around) >> SHIFT;
                last = Math.min(stride - 1, last + around) >> SHIFT;
                lastRow = Math.min(lines - 1, lastRow + around) >> SHIFT;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    for (var column:int = first; column <= last; column++)
                    {
                        // some rows and columns around count too
                        findRange(level - 1, Math.max(0, (column << SHIFT) - around), Math.max(0, (row << SHIFT) - around),
                                Math.min(stride, ((column + 1) << SHIFT) + around) - 1, Math.min(lines, ((row + 1) << SHIFT) + around) - 1, _range);
                        var at:int = begins[level] + 3 * (row * countSquares(columns, level) + column);
                        bounds[at] = _range.least;
                        bounds[int(at + 1)] = _range.greatest;
                        bounds[int(at + 2)] = Math.max(_range.stepX, _range.stepY);
                    }
                }
            }
        }

        /** Finds the least and the greatest height of a range of heights or of a level's squares, and how much neighbours differ. */
        public function findRange(level:int, first:int, firstRow:int, last:int, lastRow:int, out:HeightRange):void
        {
            var all:Vector.<Number> = heights;
            var stride:int = countSquares(columns, level);
            var low:Number = Infinity;
            var high:Number = -Infinity;
            var alongX:Number = 0;
            var alongY:Number = 0;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = first; column <= last; column++)
                {
                    var at:int = row * stride + column;
                    if (level == 0)
                    {
                        var here:Number = all[at];
                        low = here < low ? here : low;
                        high = here > high ? here : high;
                        var step:Number = column == first ? 0 : here - all[int(at - 1)];
                        alongX = step > alongX ? step : alongX;
                        alongX = -step > alongX ? -step : alongX;
                        step = row == firstRow ? 0 : here - all[int(at - columns)];
                        alongY = step > alongY ? step : alongY;
                        alongY = -step > alongY ? -step : alongY;
                        continue;
                    }
                    at = begins[level] + 3 * at;
                    low = Math.min(low, bounds[at]);
                    high = Math.max(high, bounds[int(at + 1)]);
                    alongX = alongY = Math.max(alongX, bounds[int(at + 2)]);
                }
            }
            out.least = low;
            out.greatest = high;
            out.stepX = alongX;
            out.stepY = alongY;
        }

        /**
         * Finds bounds of the heights that the ground has within a reach of a place along x and y, and of how much neighbours differ. A large
         * range is extended to whole squares.
         */
        public function findAround(atX:Number, atY:Number, reachX:Number, reachY:Number, out:HeightRange):void
        {
            var border:Number = isBlocky ? 0.5 : 0;
            var toX:Number = (atX - x) / cellWidth;
            var toY:Number = (atY - y) / cellWidth;
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
            findRange(level, first, firstRow, last, lastRow, out);
        }
    }
}
