package starlogo.terrain
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /**
     * Finds the triangles of the ground's surface that a box may meet, one after the other. If the box moves, they come nearly in the order of
     * its way.
     *
     * <p>The surface consists of the cells' tops and of upright walls. At the terrain's borders, walls reach down to below the box. With
     * columns, a wall also stands between two columns of different heights.</p>
     *
     * <p>It walks over blocks of cells. If the box comes to the heights of a block, it walks over the block's cells.</p>
     */
    internal final class GroundFaces
    {
        // Two triangles on top, and two for each of four sides.
        private static const FACES:int = 10;

        /** The box. It must be set before <code>begin()</code>. */
        public var box:PassingBox = new PassingBox();

        /** The corners of the triangle, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** The largest gap across which the triangle and another shape still touch. It depends on the size of the triangle. */
        public var gap:Number = 0;

        /** How far triangles are moved into the ground. */
        public var inset:Number = 0;

        private var _grid:HeightGrid;
        private var _heights:Vector.<Number>;
        private var _isBlocky:Boolean;
        private var _columns:int;
        private var _lastColumn:int;
        private var _lastRow:int;
        private var _blocks:GridWalk;
        private var _cells:GridWalk;

        // The current cell: the number of its next triangle, and its corners, counter-clockwise.
        private var _face:int = FACES;
        private var _x:Vector.<Number> = new Vector.<Number>(4, true);
        private var _y:Vector.<Number> = new Vector.<Number>(4, true);
        private var _z:Vector.<Number> = new Vector.<Number>(4, true);
        private var _outside:ContactPoint = new ContactPoint();

        /** Creates a finder without ground. */
        public function GroundFaces()
        {
            _blocks = new GridWalk(box);
            _cells = new GridWalk(box);
        }

        /** Begins with the box. The box becomes a little wider, because of rounding. */
        public function begin(grid:HeightGrid):void
        {
            var width:Number = grid.cellWidth;
            var middle:Number = grid.isBlocky ? width / 2 : 0;
            _grid = grid;
            _heights = grid.heights;
            _isBlocky = grid.isBlocky;
            _columns = grid.columns;
            _lastColumn = _isBlocky ? _columns - 1 : _columns - 2;
            _lastRow = _isBlocky ? grid.rows - 1 : grid.rows - 2;
            _cells.width = width;
            _blocks.width = width * (1 << HeightGrid.BLOCK);
            _cells.originX = _blocks.originX = grid.x - middle;
            _cells.originY = _blocks.originY = grid.y - middle;
            var rounding:Number = inset + Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(box.y) + Math.abs(box.z) + width
                    + box.limit * (Math.abs(box.wayX) + Math.abs(box.wayY) + Math.abs(box.wayZ)));
            box.halfX += rounding;
            box.halfY += rounding;
            box.halfZ += rounding;
            _cells.begin(0, 0, -1, -1);
            _blocks.begin(0, 0, _lastColumn >> HeightGrid.BLOCK, _lastRow >> HeightGrid.BLOCK);
            _face = FACES;
        }

        /** Sets a contact's normal to the normal of a triangle of the ground's surface. It points out of the ground. */
        public static function findOutside(p:Vector.<Number>, out:ContactPoint):void
        {
            var ux:Number = p[3] - p[0];
            var uy:Number = p[4] - p[1];
            var uz:Number = p[5] - p[2];
            var vx:Number = p[6] - p[0];
            var vy:Number = p[7] - p[1];
            var vz:Number = p[8] - p[2];
            out.setNormal(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
            out.normalise();
        }

        /** Goes on to the next triangle. Returns false if there is none. */
        public function next():Boolean
        {
            while (true)
            {
                while (_face < FACES)
                {
                    _face++;
                    if (findFace(_face - 1))
                    {
                        return true;
                    }
                }
                if (!findCell())
                {
                    return false;
                }
                _face = 0;
            }
            return false;
        }

        private function findCell():Boolean
        {
            while (true)
            {
                while (_cells.next())
                {
                    readCell(_cells.column, _cells.row);
                    if (meetsCell())
                    {
                        return true;
                    }
                }
                if (!_blocks.next())
                {
                    return false;
                }
                if (meetsBlock(_blocks.column, _blocks.row))
                {
                    var first:int = _blocks.column << HeightGrid.BLOCK;
                    var firstRow:int = _blocks.row << HeightGrid.BLOCK;
                    var most:int = (1 << HeightGrid.BLOCK) - 1;
                    _cells.begin(first, firstRow, Math.min(first + most, _lastColumn), Math.min(firstRow + most, _lastRow));
                }
            }
            return false;
        }

        // Whether the box comes to the heights of a block. A block at the terrain's border has walls that reach down below any box.
        private function meetsBlock(column:int, row:int):Boolean
        {
            var block:int = row * _grid.blockColumns + column;
            if (_blocks.low > _grid.greatests[block])
            {
                return false;
            }
            return _blocks.high >= _grid.leasts[block] || column == 0 || row == 0 || column == _lastColumn >> HeightGrid.BLOCK
                || row == _lastRow >> HeightGrid.BLOCK;
        }

        private function readCell(column:int, row:int):void
        {
            var width:Number = _cells.width;
            var at:int = row * _columns + column;
            var z:Number = _heights[at];
            _x[0] = _x[3] = _cells.originX + column * width;
            _x[1] = _x[2] = _cells.originX + (column + 1) * width;
            _y[0] = _y[1] = _cells.originY + row * width;
            _y[2] = _y[3] = _cells.originY + (row + 1) * width;
            _z[0] = z;
            if (_isBlocky)
            {
                _z[1] = _z[2] = _z[3] = z;
                return;
            }
            _z[1] = _heights[int(at + 1)];
            _z[2] = _heights[int(at + _columns + 1)];
            _z[3] = _heights[int(at + _columns)];
        }

        // Whether the box comes to the heights of the cell. With columns, the walls to the next column and to the next row belong to the cell.
        private function meetsCell():Boolean
        {
            var low:Number = Math.min(Math.min(_z[0], _z[1]), Math.min(_z[2], _z[3]));
            var high:Number = Math.max(Math.max(_z[0], _z[1]), Math.max(_z[2], _z[3]));
            if (_isBlocky)
            {
                var at:int = _cells.row * _columns + _cells.column;
                var east:Number = _cells.column < _lastColumn ? _heights[int(at + 1)] : low;
                var north:Number = _cells.row < _lastRow ? _heights[int(at + _columns)] : low;
                low = Math.min(low, Math.min(east, north));
                high = Math.max(high, Math.max(east, north));
            }
            gap = Tolerances.SURFACES * (_cells.width + high - low);
            if (_cells.low > high + gap)
            {
                return false;
            }
            return _cells.high >= low - gap || _cells.column == 0 || _cells.row == 0 || _cells.column == _lastColumn || _cells.row == _lastRow;
        }

        // Writes the triangle with a number. Returns false if the cell has no such triangle, or if the box is above or below it.
        private function findFace(face:int):Boolean
        {
            if (face < 2)
            {
                put(0, 0);
                put(3, face + 1);
                put(6, face + 2);
            }
            else if (!findWall((face - 2) >> 1, (face & 1) == 1))
            {
                return false;
            }
            var low:Number = Math.min(corners[2], Math.min(corners[5], corners[8]));
            var high:Number = Math.max(corners[2], Math.max(corners[5], corners[8]));
            if (_cells.low > high + gap || _cells.high < low - gap)
            {
                return false;
            }
            if (inset > 0)
            {
                moveIn();
            }
            return true;
        }

        // Writes half of the wall on a side, from one corner to the next. The half with the upper edge comes second.
        private function findWall(side:int, isUpper:Boolean):Boolean
        {
            var end:int = (side + 1) & 3;
            var top:Number = _z[side];
            var endTop:Number = _z[end];
            var low:Number;
            if (isAtBorder(side))
            {
                low = Math.min(_cells.low, Math.min(top, endTop)) - _cells.width;
            }
            else if (_isBlocky && (side == 1 || side == 2))
            {
                low = _heights[int(_cells.row * _columns + _cells.column + (side == 1 ? 1 : _columns))];
                if (low == top)
                {
                    return false;
                }
                if (low > top)
                {
                    // The next column is higher, so this is its wall, seen from here.
                    endTop = low;
                    low = top;
                    top = endTop;
                    end = side;
                    side = (side + 1) & 3;
                }
            }
            else
            {
                return false;
            }
            put(0, side);
            put(3, end);
            put(6, isUpper ? side : end);
            corners[2] = low;
            corners[5] = isUpper ? endTop : low;
            corners[8] = isUpper ? top : endTop;
            return true;
        }

        private function isAtBorder(side:int):Boolean
        {
            if (side == 0)
            {
                return _cells.row == 0;
            }
            if (side == 1)
            {
                return _cells.column == _lastColumn;
            }
            return side == 2 ? _cells.row == _lastRow : _cells.column == 0;
        }

        private function put(to:int, corner:int):void
        {
            corners[to] = _x[corner];
            corners[int(to + 1)] = _y[corner];
            corners[int(to + 2)] = _z[corner];
        }

        private function moveIn():void
        {
            findOutside(corners, _outside);
            for (var i:int = 0; i < 9; i += 3)
            {
                corners[i] -= inset * _outside.normalX;
                corners[int(i + 1)] -= inset * _outside.normalY;
                corners[int(i + 2)] -= inset * _outside.normalZ;
            }
        }
    }
}
