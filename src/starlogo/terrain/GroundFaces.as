package starlogo.terrain
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /**
     * Finds the triangles of the ground's surface that a box may meet, one after the other: on a way nearly in its order. The surface is the tops of the cells;
     * at the borders of the terrain upright walls, down to below the box; and between columns of different heights upright walls.
     *
     * <p>It walks blocks of cells, and the cells of those whose heights the box comes to.</p>
     */
    internal final class GroundFaces
    {
        // Two triangles on top, and two for each of four sides.
        private static const FACES:int = 10;

        /** The box; to be set, then <code>begin()</code>. */
        public var box:PassingBox = new PassingBox();

        /** The corners of the triangle, nine numbers; counter-clockwise as seen from outside of the ground. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** How far apart the triangle and another shape may be, because of the triangle's size, and still touch. */
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

        // Of the cell: its next triangle, and its corners, counter-clockwise.
        private var _face:int = FACES;
        private var _x:Vector.<Number> = new Vector.<Number>(4, true);
        private var _y:Vector.<Number> = new Vector.<Number>(4, true);
        private var _z:Vector.<Number> = new Vector.<Number>(4, true);
        private var _outside:ContactPoint = new ContactPoint();

        /** No ground yet. */
        public function GroundFaces()
        {
            _blocks = new GridWalk(box);
            _cells = new GridWalk(box);
        }

        /** Begins with the box, which is made a little wider because of rounding. */
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

        /** Points a normal out of the ground from a triangle of its surface, or from one that was kept. */
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

        /** Goes on to the next triangle; false if there is none. */
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

        // The walls at the terrain's borders are as deep as may be.
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

        // Of columns the walls to the next ones too are the cell's.
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

        // Writes a triangle; false if the cell has none of that number, or the box is above or below it.
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

        // A wall stands on the side from one corner to the next. The half with the upper edge comes last.
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
                    // it is the other one's, seen from here
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
