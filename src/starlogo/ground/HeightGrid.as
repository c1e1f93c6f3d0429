// This room says how shapes and rays meet the ground, a solid whose surface is triangles over a grid of heights. Open HeightGrid first: it has the heights,
// and HeightPyramid bounds of them. Then read GroundModelQuery, which tests a model:
// 1. Do the two touch? GroundEarlyOut knows it of most agents by the heights alone, and DeepestPointSearch of most others that touch. For the
// rest PieceTrianglePairs are the convex pieces of the model (ModelPiece), each with the triangles near it. GroundTriangles finds these near the box of a
// GroundSearch: square by square (BoxPath), then those of each cell (CellTriangles).
// 2. How deep is the model? GroundPushSearch finds the push of most contacts, by planes alone (GroundPlanes). DeepestPointSearch adds the plane of the exit
// of the deepest point, which RidgeExitSearch finds across a ridge. An exit leads one point out, a push the whole model. So GroundSeparation looks for a
// plane between the pushed model and each GroundFacet under it. A facet in the way has the next plane. GroundExits proves that no exit is much shorter.
// 3. If no push is found, GroundPenetrationQuery finds a triangle that the model is deep behind, and the PenetrationSearch of search goes on from there.
// GroundRayQuery tests a ray by the same GroundTriangles.
package starlogo.ground
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.geometry.Tolerances;

    /**
     * The heights of a terrain, and its holes: how high the ground is at a place. It is copied on write: who changes it changes
     * <code>writable()</code>, which is a copy while frames hold the grid.
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

        // How much a place may be off by rounding, in cells. A place at a wall is on both of its sides, so no ray begins behind a wall and beside the ground.
        private var _rounding:Number;

        // The number of frames that need the ground as it is.
        private var _holders:int = 0;

        private var _point:GroundPoint = new GroundPoint();

        // A grid that has been a copy of this one, or of which this one is a copy; or null.
        private var _spareCopy:HeightGrid = null;

        public function HeightGrid(columns:int, rows:int, cellWidth:Number, x:Number, y:Number)
        {
            this.columns = columns;
            this.rows = rows;
            this.cellWidth = cellWidth;
            this.x = x;
            this.y = y;
            _rounding = Math.min(0.5, Tolerances.ROUNDING * (Math.max(Math.abs(x), Math.abs(y)) / cellWidth + Math.max(columns, rows)));
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
            if (_spareCopy == null || _spareCopy._holders > 0)
            {
                _spareCopy = new HeightGrid(columns, rows, cellWidth, x, y);
                _spareCopy._spareCopy = this;
            }
            _spareCopy.isBlocky = isBlocky;
            for (var i:int = 0; i < heights.length; i++)
            {
                _spareCopy.heights[i] = heights[i];
            }
            _spareCopy.holes = holes.concat();
            _spareCopy.pyramid.copyFrom(pyramid);
            return _spareCopy;
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
        public function readFrom(bytes:ByteArray):HeightGrid
        {
            return HeightBytes.read(bytes, this);
        }

        /**
         * Finds the cell at a point: the block there, or else the cell of slopes, which may be a hole. At a border between cells it may be any of them.
         * Returns false if the point is outside of the outermost cells by more than rounding.
         */
        public function findCell(point:GroundPoint, areBlocks:Boolean):Boolean
        {
            var before:Number = areBlocks ? 0.5 : 0;
            var toX:Number = (point.x - x) / cellWidth + before;
            var toY:Number = (point.y - y) / cellWidth + before;
            var cellsX:int = areBlocks ? columns : columns - 1;
            var cellsY:int = areBlocks ? rows : rows - 1;
            if (!(toX >= -_rounding && toY >= -_rounding && toX <= cellsX + _rounding && toY <= cellsY + _rounding))
            {
                return false;
            }
            // the conversion to int rounds towards 0
            point.column = Math.min(toX, cellsX - 1);
            point.row = Math.min(toY, cellsY - 1);
            return true;
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

        /** Finds the height at a point's x and y, and its cell. */
        public function findHeight(point:GroundPoint):void
        {
            if (!findCell(point, isBlocky))
            {
                point.height = NaN;
                return;
            }
            var at:int = point.row * columns + point.column;
            point.height = heights[at];
            if (isBlocky || pyramid.whole.hasHole && isHole(at))
            {
                goToHighestCell(point);
            }
            if (!isBlocky && !isNaN(point.height))
            {
                findHeightOfSlope(point);
            }
        }

        // Chooses the cell with the highest first height of those at a point, up to rounding. The height becomes NaN if all are holes.
        private function goToHighestCell(point:GroundPoint):void
        {
            var toX:Number = (point.x - x + border) / cellWidth;
            var toY:Number = (point.y - y + border) / cellWidth;
            var firstColumn:int = Math.floor(toX - _rounding);
            var firstRow:int = Math.floor(toY - _rounding);
            var lastColumn:int = Math.floor(toX + _rounding);
            var lastRow:int = Math.floor(toY + _rounding);
            point.height = NaN;
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = firstColumn; column <= lastColumn; column++)
                {
                    if (hasCell(column, row) && !(heights[int(row * columns + column)] <= point.height))
                    {
                        point.column = column;
                        point.row = row;
                        point.height = heights[int(row * columns + column)];
                    }
                }
            }
        }

        // Finds the height of the slope at a point of a cell, and in which of the cell's two triangles the point is.
        private function findHeightOfSlope(point:GroundPoint):void
        {
            var toX:Number = (point.x - x) / cellWidth - point.column;
            var toY:Number = (point.y - y) / cellWidth - point.row;
            var corner:int = point.row * columns + point.column;
            point.isBesideX = toX >= toY;
            var more:Number = point.isBesideX ? toX : toY;
            var less:Number = point.isBesideX ? toY : toX;
            point.height = (1 - more) * heights[corner] + (more - less) * heights[sideOf(point)] + less * heights[int(corner + columns + 1)];
        }

        // The height that only the triangle of a point has, and not the other one of its cell.
        private function sideOf(point:GroundPoint):int
        {
            var corner:int = point.row * columns + point.column;
            return point.isBesideX ? corner + 1 : corner + columns;
        }

        /** Finds the normal at a point whose height is known: a unit vector out of the ground. It is up from blocks, and where there is no ground. */
        public function findNormal(point:GroundPoint, out:Vector3D):void
        {
            // not setTo, because a game in JavaScript may give any object with x, y and z; and V8 would make objects for the Numbers
            out.x = out.y = 0;
            out.z = 1;
            if (!isBlocky && !isNaN(point.height))
            {
                var corner:int = point.row * columns + point.column;
                var side:int = sideOf(point);
                var toSide:Number = heights[corner] - heights[side];
                var fromSide:Number = heights[side] - heights[int(corner + columns + 1)];
                // how far the triangle falls from a height to the next one along x, and along y
                var fallX:Number = point.isBesideX ? toSide : fromSide;
                var fallY:Number = point.isBesideX ? fromSide : toSide;
                var length:Number = Math.sqrt(fallX * fallX + fallY * fallY + cellWidth * cellWidth);
                out.x = fallX / length;
                out.y = fallY / length;
                out.z = cellWidth / length;
            }
        }
    }
}
