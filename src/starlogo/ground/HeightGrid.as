// This room says how shapes and rays meet the ground, a solid whose surface is triangles over a grid of heights. HeightGrid has the heights, and
// HeightPyramid bounds of them. Three parts build on these:
// - GroundTriangles finds the triangles near the box of a GroundSearch: square by square (BoxPath), then those of each cell (CellTriangles).
// - GroundModelQuery tests a model. PieceTrianglePairs are its convex pieces (ModelPieces), each with the triangles near it (NearTriangles).
// GroundPenetrationQuery finds how deep the model is, GroundExits a lower bound of the lengths of its exits.
// - GroundRayQuery tests a ray, and GroundEarlyOut decides about most agents by the heights alone.
// Read this file first, then GroundSearch, GroundTriangles and GroundModelQuery.
package starlogo.ground
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;

    /**
     * The heights of a terrain, and its holes: how high the ground is at a place.
     *
     * <p>Frequent questions write to records, because V8 allocates an object for each Number that is passed or returned.</p>
     *
     * @private
     */
    public final class HeightGrid
    {
        /** How many heights there are along x. */
        public var columns:int;

        /** How many heights there are along y. */
        public var rows:int;

        /** How far neighbours are apart, in patches. */
        public var cellWidth:Number;

        /** The place of the first height, in the world. */
        public var x:Number;
        public var y:Number;

        /** Whether the surface is upright blocks; otherwise it is slopes. */
        public var isBlocky:Boolean = false;

        /** The heights, row by row. Read only. */
        public var heights:Vector.<Number>;

        /**
         * A bit for each cell: whether it is a hole. 32 cells are one number, in the order of the heights. The cell of a height is the block
         * around it, or the slopes between it and the next heights along x and y. Read only.
         */
        public var holes:Vector.<int>;

        /** Bounds of the heights. Read only. */
        public var pyramid:HeightPyramid;

        // The number of frames that need the ground as it is.
        private var _holders:int = 0;

        private var _point:GroundPoint = new GroundPoint();

        // A grid that has been a copy of this one, or of which this one is a copy; or null.
        private var _spare:HeightGrid = null;

        public function HeightGrid(columns:int, rows:int, cellWidth:Number, x:Number, y:Number)
        {
            this.columns = columns;
            this.rows = rows;
            this.cellWidth = cellWidth;
            this.x = x;
            this.y = y;
            heights = new Vector.<Number>(columns * rows, true);
            holes = new Vector.<int>((columns * rows + 31) >> 5, true);
            pyramid = new HeightPyramid(this);
        }

        /** Sets the heights of a region, which has a height for each place, row by row. */
        public function setHeights(column:int, row:int, columns:int, rows:int, heights:Vector.<Number>):void
        {
            var i:int = 0;
            for (var toRow:int = row; toRow < row + rows; toRow++)
            {
                for (var toColumn:int = column; toColumn < column + columns; toColumn++)
                {
                    // plus 0, because -0 becomes 0, which is the only height that snapshots leave out
                    this.heights[int(toRow * this.columns + toColumn)] = heights[i] + 0;
                    i++;
                }
            }
            pyramid.update(column, row, column + columns - 1, row + rows - 1);
        }

        /** Makes all heights 0, without holes. */
        public function reset():void
        {
            setSurface(isBlocky, new Vector.<Number>(columns * rows, true), new Vector.<int>(holes.length, true));
        }

        /** Sets all of the surface. The heights and the holes are kept. */
        public function setSurface(isBlocky:Boolean, heights:Vector.<Number>, holes:Vector.<int>):void
        {
            this.isBlocky = isBlocky;
            this.heights = heights;
            this.holes = holes;
            pyramid.update(0, 0, columns - 1, rows - 1);
        }

        /** Notes that one more frame needs the ground as it is. Then it must not change. */
        public function hold():void
        {
            _holders++;
        }

        /** Notes that a frame that held the ground needs it no longer. */
        public function release():void
        {
            _holders--;
        }

        /** Returns this grid, or a copy if a frame holds it: what may change. An earlier copy is used again. */
        public function writable():HeightGrid
        {
            if (_holders == 0)
            {
                return this;
            }
            if (_spare == null || _spare._holders > 0)
            {
                _spare = new HeightGrid(columns, rows, cellWidth, x, y);
                _spare._spare = this;
            }
            _spare.isBlocky = isBlocky;
            for (var i:int = 0; i < heights.length; i++)
            {
                _spare.heights[i] = heights[i];
            }
            _spare.holes = holes.concat();
            _spare.pyramid.copyFrom(pyramid);
            return _spare;
        }

        /** Writes the surface for a snapshot: a method, so that a game without ground does not load HeightBytes. */
        public function writeTo(bytes:ByteArray):void
        {
            HeightBytes.write(bytes, this);
        }

        /**
         * Reads a surface that was written: a grid of the same cells with it.
         *
         * @throws ArgumentError if they are a surface of other cells
         * @throws EOFError if they are cut off
         * @throws RangeError if they are no surface
         */
        public function read(bytes:ByteArray):HeightGrid
        {
            return HeightBytes.read(bytes, this);
        }

        /**
         * Whether a point is between the sides of the outermost blocks, or else between those of the outermost cells of slopes, as seen from above;
         * over a hole too.
         */
        public function isWithin(point:GroundPoint, areBlocks:Boolean):Boolean
        {
            var beyond:Number = areBlocks ? cellWidth / 2 : 0;
            return point.x >= x - beyond && point.y >= y - beyond && point.x <= x + (columns - 1) * cellWidth + beyond && point.y <= y + (rows - 1) * cellWidth + beyond;
        }

        /** How far beyond the outermost heights the ground goes on: half a cell of blocks. Slopes end at these heights. */
        public function get border():Number
        {
            return isBlocky ? cellWidth / 2 : 0;
        }

        /** Whether the cell of a height is a hole. */
        public function isHole(index:int):Boolean
        {
            return (holes[index >> 5] >> (index & 31) & 1) == 1;
        }

        /** Whether one of the four cells beside the cell of a height is a hole. The cell is not at a border. */
        public function isBesideHole(index:int):Boolean
        {
            return isHole(index - 1) || isHole(index + 1) || isHole(index - columns) || isHole(index + columns);
        }

        /** Whether there is a cell at a column and a row, and it is no hole. */
        public function hasCell(column:int, row:int):Boolean
        {
            return column >= 0 && row >= 0 && column <= lastCellColumn && row <= lastCellRow && !isHole(row * columns + column);
        }

        /** The last column of cells. Blocks are around heights, slopes between them. */
        public function get lastCellColumn():int
        {
            return isBlocky ? columns - 1 : columns - 2;
        }

        /** The last row of cells. */
        public function get lastCellRow():int
        {
            return isBlocky ? rows - 1 : rows - 2;
        }

        /** Makes the cell of a height a hole, or fills it. */
        public function setHole(column:int, row:int, becomesHole:Boolean):void
        {
            var index:int = row * columns + column;
            var bit:int = 1 << (index & 31);
            holes[index >> 5] = becomesHole ? holes[index >> 5] | bit : holes[index >> 5] & ~bit;
            pyramid.update(column, row, column, row);
        }

        /** The height at a place; NaN outside and over holes. Where blocks meet, it is the height of the highest. */
        public function heightAt(atX:Number, atY:Number):Number
        {
            _point.x = atX;
            _point.y = atY;
            findHeight(_point);
            return _point.height;
        }

        /** Finds the height at a point's x and y, and on slopes its triangle. */
        public function findHeight(point:GroundPoint):void
        {
            if (!isWithin(point, isBlocky))
            {
                point.height = NaN;
            }
            else if (isBlocky)
            {
                findHeightOfBlocks(point);
            }
            else
            {
                findHeightOfSlopes(point);
            }
        }

        // Finds the height of the highest block at a point; NaN if all are holes. At most four blocks meet there.
        private function findHeightOfBlocks(point:GroundPoint):void
        {
            // rounding can lead beyond the last block
            var toX:Number = Math.min((point.x - x) / cellWidth + 0.5, columns);
            var toY:Number = Math.min((point.y - y) / cellWidth + 0.5, rows);
            var firstColumn:int = Math.max(0, Math.ceil(toX) - 1);
            var lastColumn:int = Math.min(toX, columns - 1);
            var lastRow:int = Math.min(toY, rows - 1);
            point.height = NaN;
            for (var row:int = Math.max(0, Math.ceil(toY) - 1); row <= lastRow; row++)
            {
                for (var index:int = row * columns + firstColumn; index <= row * columns + lastColumn; index++)
                {
                    if (!isHole(index) && !(heights[index] <= point.height))
                    {
                        point.height = heights[index];
                    }
                }
            }
        }

        // Finds the height of the slope at a point, and its triangle.
        private function findHeightOfSlopes(point:GroundPoint):void
        {
            var toX:Number = (point.x - x) / cellWidth;
            var toY:Number = (point.y - y) / cellWidth;
            // The conversion to int rounds down, because the numbers are not negative.
            var column:int = Math.min(toX, columns - 2);
            var row:int = Math.min(toY, rows - 2);
            var corner:int = row * columns + column;
            if (pyramid.whole.hasHole && isHole(corner))
            {
                corner = cellBeside(corner, toX == column && column > 0, toY == row && row > 0);
                if (corner < 0)
                {
                    point.height = NaN;
                    return;
                }
                column = corner % columns;
                row = corner / columns;
            }
            toX -= column;
            toY -= row;
            point.corner = corner;
            point.side = toX >= toY ? corner + 1 : corner + columns;
            var more:Number = toX >= toY ? toX : toY;
            var less:Number = toX >= toY ? toY : toX;
            point.height = (1 - more) * heights[corner] + (more - less) * heights[point.side] + less * heights[int(corner + columns + 1)];
        }

        // The cell beside a hole to which a place at the hole's border belongs, or -1. The place is at the border to the cell before the hole
        // along x, or along y, or at both.
        private function cellBeside(hole:int, isAtX:Boolean, isAtY:Boolean):int
        {
            if (isAtX && !isHole(hole - 1))
            {
                return hole - 1;
            }
            if (isAtY && !isHole(hole - columns))
            {
                return hole - columns;
            }
            return isAtX && isAtY && !isHole(hole - columns - 1) ? hole - columns - 1 : -1;
        }

        /** Finds the normal at a point whose height is known: a unit vector out of the ground. It is up from blocks, and where there is no ground. */
        public function findNormal(point:GroundPoint, out:Vector3D):void
        {
            // not setTo, because a game in JavaScript may give any object with x, y and z; and V8 would make objects for the Numbers
            out.x = out.y = 0;
            out.z = 1;
            if (!isBlocky && !isNaN(point.height))
            {
                var toSide:Number = heights[point.corner] - heights[point.side];
                var fromSide:Number = heights[point.side] - heights[int(point.corner + columns + 1)];
                var isSideAlongX:Boolean = point.side == point.corner + 1;
                // how far the triangle falls from a height to the next one along x, and along y
                var fallX:Number = isSideAlongX ? toSide : fromSide;
                var fallY:Number = isSideAlongX ? fromSide : toSide;
                var length:Number = Math.sqrt(fallX * fallX + fallY * fallY + cellWidth * cellWidth);
                out.x = fallX / length;
                out.y = fallY / length;
                out.z = cellWidth / length;
            }
        }

        /**
         * Moves a point to a point of the grid that belongs to the ground, and finds the height there. It is the nearest one as seen from above,
         * or one around it if that is in a hole. If all of the ground is holes, the height becomes Infinity.
         */
        public function findNearest(point:GroundPoint):void
        {
            var column:int = Math.max(0, Math.min(columns - 1, Math.round((point.x - x) / cellWidth)));
            var row:int = Math.max(0, Math.min(rows - 1, Math.round((point.y - y) / cellWidth)));
            point.height = Infinity;
            for (var ring:int = 0; point.height == Infinity && ring < columns + rows; ring++)
            {
                findOnRing(column, row, ring, point);
            }
        }

        // Moves a point to the last height of a ring that belongs to the ground, if there is one. The ring is the border of a square of heights around a
        // height. <code>ring</code> is how many columns and rows away from that height the border is.
        private function findOnRing(column:int, row:int, ring:int, point:GroundPoint):void
        {
            for (var i:int = Math.max(0, row - ring); i <= Math.min(rows - 1, row + ring); i++)
            {
                // in rows between the first and the last, only both ends
                var step:int = Math.abs(i - row) == ring ? 1 : 2 * ring;
                for (var k:int = column - ring; k <= column + ring; k += step)
                {
                    if (k >= 0 && k < columns && isOfCell(k, i))
                    {
                        point.x = x + k * cellWidth;
                        point.y = y + i * cellWidth;
                        point.height = heights[int(i * columns + k)];
                    }
                }
            }
        }

        // Whether a height belongs to a cell that is no hole.
        private function isOfCell(column:int, row:int):Boolean
        {
            return hasCell(column, row) || !isBlocky && (hasCell(column - 1, row) || hasCell(column, row - 1) || hasCell(column - 1, row - 1));
        }
    }
}
