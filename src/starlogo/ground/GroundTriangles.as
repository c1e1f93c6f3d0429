package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;

    use namespace engine;

    /**
     * Finds the triangles of the ground's surface that a box may meet, one after the other: the source of triangles for all tests of the
     * ground, and for drawing it. If the box moves, they come nearly in the order in which it meets them.
     *
     * <p>The surface consists of the cells' tops and of upright walls. A wall stands where a column is higher than its neighbour, at the
     * terrain's borders and around holes. If the box has no floor, a wall goes down to below the box and below the cell's top, and up to a
     * little above the box. A hole has no triangles.</p>
     *
     * <p>A stack has the squares that are still to be visited. If the box comes to the heights of a square, its smaller squares take its
     * place. The smallest squares, of level 0, are the cells.</p>
     *
     * @private
     */
    public final class GroundTriangles
    {
        // The search begins with squares of which the box is at most this many long, because most boxes are small.
        private static const FIRST_SQUARES:int = 3;

        // How much farther than rounding errors a structure is from squares that are left out.
        private static const FARTHER:Number = 4;

        // Where the neighbour on each side of a cell is, counter-clockwise from the side with the least y on.
        private static const TO_COLUMN:Vector.<int> = new <int>[0, 1, 0, -1];
        private static const TO_ROW:Vector.<int> = new <int>[-1, 0, 1, 0];

        /** The corners of the triangle, nine numbers; counter-clockwise as seen from outside of the ground. Read only. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** A length that no side of the triangle is longer than, and the margin that the triangle has because of it (see Touching). Read only. */
        public var size:Number = 0;
        public var margin:Number = 0;

        private var _grid:HeightGrid;
        private var _box:GroundBox;

        // Half the box's lengths, with a margin for rounding.
        private var _halfX:Number = 0;
        private var _halfY:Number = 0;
        private var _halfZ:Number = 0;

        private var _lastColumn:int;
        private var _lastRow:int;

        // Where the first cell begins, and the height 0.
        private var _corner:Vector3D = new Vector3D();

        // The part of the motion that cut() narrows, and the square of how far above or below the box something may be there.
        private var _from:Number = 0;
        private var _to:Number = 0;
        private var _squared:Number = 0;

        // Level, column and row of each square that is still to be visited, and how many numbers these are.
        private var _squares:Vector.<int> = new Vector.<int>();
        private var _top:int = 0;

        // The current square: its place, its width, and the heights between which the box is over it.
        private var _column:int = 0;
        private var _row:int = 0;
        private var _width:Number = 1;
        private var _low:Number = 0;
        private var _high:Number = 0;

        // Along x and y: the box's middle, half of its length and its motion, and where the first cell begins. A list, because V8 would make objects
        // for Numbers that are passed.
        private var _alongAxes:Vector.<Number> = new Vector.<Number>(8, true);

        // The latest time at the beginning of the search.
        private var _whole:Number = 0;

        // The results of passOver(): the heights between which the box is over the current square. For a cell with walls these are the heights up
        // to _whole. Tall walls are cut there, so no corner depends on what the latest time has become.
        private var _passLow:Number = 0;
        private var _passHigh:Number = 0;

        // How far the structure and the current square are apart, two corners of the square's extents, and the distance that rounding errors may
        // hide.
        private var _separation:SeparationFromBox = new SeparationFromBox();
        private var _least:Vector3D = new Vector3D();
        private var _greatest:Vector3D = new Vector3D();
        private var _slack:Number = 0;

        // The current cell: its next triangle, the number of its triangles, and the heights of its corners, counter-clockwise.
        private var _face:int = 0;
        private var _faceCount:int = 0;
        private var _tops:Vector.<Number> = new Vector.<Number>(4, true);

        // The results of findRange().
        private var _first:int = 0;
        private var _last:int = 0;

        /** Begins a search. The two objects are kept until it ends. */
        public function begin(grid:HeightGrid, box:GroundBox):void
        {
            var motion:RelativeMotion = box.motion;
            var latest:Number = box.latest;
            var width:Number = grid.cellWidth;
            var border:Number = grid.isBlocky ? width / 2 : 0;
            var fewer:int = grid.isBlocky ? 1 : 2;
            _grid = grid;
            _box = box;
            _lastColumn = grid.columns - fewer;
            _lastRow = grid.rows - fewer;
            _corner.setTo(grid.x - box.origin.x - border, grid.y - box.origin.y - border, -box.origin.z);
            stop();
            _from = 0;
            _to = _whole = latest;
            var pathX:Number = latest * Math.abs(motion.x);
            var pathY:Number = latest * Math.abs(motion.y);
            var rounding:Number = Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(_corner.x) + Math.abs(box.y) + Math.abs(_corner.y) + Math.abs(box.z)
                    + Math.abs(_corner.z) + width + pathX + pathY + latest * Math.abs(motion.z));
            _halfX = box.halfX + rounding;
            _halfY = box.halfY + rounding;
            _halfZ = box.halfZ + rounding;
            var length:Number = Math.max(2 * _halfX + pathX, 2 * _halfY + pathY) + 2 * box.maxDistance;
            var level:int = 0;
            while (level < grid.levels && length > FIRST_SQUARES * width * (1 << (level * HeightGrid.SHIFT)))
            {
                level++;
            }
            _slack = FARTHER * rounding;
            _alongAxes[0] = box.x;
            _alongAxes[1] = box.y;
            _alongAxes[2] = _halfX;
            _alongAxes[3] = _halfY;
            _alongAxes[4] = motion.x;
            _alongAxes[5] = motion.y;
            _alongAxes[6] = _corner.x;
            _alongAxes[7] = _corner.y;
            addSquares(level, 0, 0, int.MAX_VALUE);
        }

        /** Goes on to the next triangle. Returns false if there is none. */
        public function next():Boolean
        {
            while (_face < _faceCount || _top > 0)
            {
                if (_face == _faceCount)
                {
                    visitSquare();
                }
                else if (findFace(_face++))
                {
                    return true;
                }
            }
            return false;
        }

        /** Ends the search. */
        public function stop():void
        {
            _face = _faceCount = _top = 0;
        }

        // Puts squares of a level on the stack: those of the given ones that the box may pass over in the current part of its motion. The nearest
        // is put last, and visited first.
        private function addSquares(level:int, first:int, firstRow:int, most:int):void
        {
            var shift:int = level * HeightGrid.SHIFT;
            _width = _grid.cellWidth * (1 << shift);
            findRange(_box.x - _corner.x, _halfX + _box.maxDistance, _box.motion.x, first, Math.min(first + most - 1, _lastColumn >> shift));
            first = _first;
            var last:int = _last;
            findRange(_box.y - _corner.y, _halfY + _box.maxDistance, _box.motion.y, firstRow, Math.min(firstRow + most - 1, _lastRow >> shift));
            for (var row:int = _first; row <= _last; row++)
            {
                for (var column:int = first; column <= last; column++)
                {
                    _squares[_top] = level;
                    _squares[int(_top + 1)] = _box.motion.x < 0 ? column : first + last - column;
                    _squares[int(_top + 2)] = _box.motion.y < 0 ? row : _first + _last - row;
                    _top += 3;
                }
            }
        }

        // Takes a square from the stack. If the box comes to its heights, continues with its smaller squares, or with the cell's triangles.
        private function visitSquare():void
        {
            _top -= 3;
            var level:int = _squares[_top];
            var shift:int = level * HeightGrid.SHIFT;
            _column = _squares[int(_top + 1)];
            _row = _squares[int(_top + 2)];
            _width = _grid.cellWidth * (1 << shift);
            _to = _box.latest;
            passOver();
            _low = _passLow;
            _high = _passHigh;
            if (_from > _to)
            {
                return;
            }
            var hasWalls:Boolean = _column == 0 || _row == 0 || _column == _lastColumn >> shift || _row == _lastRow >> shift;
            if (level == 0)
            {
                visitCell(hasWalls || _grid.isBlocky);
                return;
            }
            var bounds:int = _grid.begins[level] + HeightGrid.BOUNDS * (_row * HeightGrid.countSquares(_grid.columns, level) + _column);
            var least:Number = _grid.bounds[bounds] + _corner.z;
            var greatest:Number = _grid.bounds[int(bounds + 1)] + _corner.z;
            if (hasWalls || _grid.bounds[int(bounds + 3)] > 0)
            {
                least = Math.min(least, _low);
            }
            if (_low <= greatest && _high >= least && !isBeyond(least, greatest))
            {
                if (_box.motion.z != 0)
                {
                    // only the part of the motion that is between the heights
                    var low:Number = (least - (_box.z + _halfZ)) / _box.motion.z;
                    var high:Number = (greatest - (_box.z - _halfZ)) / _box.motion.z;
                    _from = Math.max(_from, Math.min(low, high));
                    _to = Math.min(_to, Math.max(low, high));
                }
                addSquares(level - 1, _column << HeightGrid.SHIFT, _row << HeightGrid.SHIFT, 1 << HeightGrid.SHIFT);
            }
        }

        // Reads the heights of the current square, which is a cell, and begins with its triangles if the box comes to them.
        private function visitCell(hasWalls:Boolean):void
        {
            var heights:Vector.<Number> = _grid.heights;
            var at:int = _row * _grid.columns + _column;
            if (_grid.holes != null)
            {
                if (_grid.isHole(at))
                {
                    return;
                }
                // others have their own borders already
                hasWalls ||= _grid.isHole(at - 1) || _grid.isHole(at + 1) || _grid.isHole(at - _grid.columns) || _grid.isHole(at + _grid.columns);
            }
            // all corners of a column have one height
            var next:int = _grid.isBlocky ? 0 : 1;
            var far:int = next * _grid.columns;
            _tops[0] = heights[at] + _corner.z;
            _tops[1] = heights[int(at + next)] + _corner.z;
            _tops[2] = heights[int(at + next + far)] + _corner.z;
            _tops[3] = heights[int(at + far)] + _corner.z;
            var greatest:Number = Math.max(Math.max(_tops[0], _tops[1]), Math.max(_tops[2], _tops[3]));
            var least:Number = Math.min(Math.min(_tops[0], _tops[1]), Math.min(_tops[2], _tops[3]));
            if (_low <= greatest && (hasWalls || _high >= least))
            {
                if (hasWalls)
                {
                    _to = _whole;
                    passOver();
                }
                _face = 0;
                _faceCount = hasWalls ? 10 : 2;
            }
        }

        // Narrows the motion up to _to to the part in which the box is over the current square, and finds the heights between which it is there.
        private function passOver():void
        {
            _from = 0;
            _squared = _box.maxDistance * _box.maxDistance;
            cut(0, _column);
            cut(1, _row);
            var start:Number = _box.z + _from * _box.motion.z;
            var end:Number = _box.z + _to * _box.motion.z;
            // a triangle beside the box must be nearer in height to be near enough
            var up:Number = Math.sqrt(Math.max(0, _squared));
            var bottom:Number = Math.min(start, end) - _halfZ;
            _passLow = Math.max(bottom - up, bottom + _box.above + 2 * _slack);
            _passHigh = Math.max(start, end) + _halfZ + up;
        }

        // Whether the structure stays farther away from the current square than a triangle may be. The square is between two heights.
        private function isBeyond(least:Number, greatest:Number):Boolean
        {
            if (_box.structure == null)
            {
                return false;
            }
            var x:Number = _corner.x + _column * _width;
            var y:Number = _corner.y + _row * _width;
            _least.setTo(x, y, least);
            _greatest.setTo(x + _width, y + _width, greatest);
            _separation.find(_box.structure, _least, _greatest);
            var come:Number = _box.latest * (_separation.direction.x * _box.motion.x + _separation.direction.y * _box.motion.y + _separation.direction.z * _box.motion.z);
            return _separation.distance + Math.min(0, come) > _box.maxDistance + _slack;
        }

        // Writes the triangle with a number: two on top, then two on each side. Returns false if the cell has no such triangle, or if the
        // box is above or below it.
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
            size = _width + high - low;
            margin = Touching.marginOfSurface(size);
            return _low <= high && _high >= low;
        }

        // Writes half of the wall on a side, from one corner to the next. The half with the upper edge comes second. Returns false if there is
        // no wall near the box. Walls are cut a cell's width above the box, and below it if it has no floor, because long triangles have larger
        // rounding errors.
        private function findWall(side:int, isUpper:Boolean):Boolean
        {
            var end:int = (side + 1) & 3;
            var column:int = _column + TO_COLUMN[side];
            var row:int = _row + TO_ROW[side];
            var top:Number = _tops[side];
            var endTop:Number = _tops[end];
            var low:Number = _box.floor;
            var at:int = row * _grid.columns + column;
            if (column >= 0 && row >= 0 && column <= _lastColumn && row <= _lastRow && !_grid.isHole(at))
            {
                low = _grid.isBlocky ? _grid.heights[at] + _corner.z : Infinity;
            }
            if (low >= top && low >= endTop || low > _high)
            {
                return false;
            }
            low = _box.floor > -Infinity ? low : Math.min(_passLow, Math.min(top, endTop)) - _width;
            if (Math.min(top, endTop) > _passHigh + _width)
            {
                top = endTop = _passHigh + _width;
            }
            put(0, side);
            put(3, end);
            put(6, isUpper ? side : end);
            corners[2] = low;
            corners[5] = isUpper ? endTop : low;
            corners[8] = isUpper ? top : endTop;
            return true;
        }

        // Writes a corner of the cell's top.
        private function put(to:int, corner:int):void
        {
            corners[to] = _corner.x + (_column + ((corner + 1) >> 1 & 1)) * _width;
            corners[int(to + 1)] = _corner.y + (_row + (corner >> 1)) * _width;
            corners[int(to + 2)] = _tops[corner];
        }

        // Narrows the part of the motion to the part in which the box comes over the current square, or near enough to it, along one axis.
        private function cut(axis:int, square:int):void
        {
            var at:Number = _alongAxes[axis];
            var extent:Number = _alongAxes[int(axis + 2)];
            var motion:Number = _alongAxes[int(axis + 4)];
            var begin:Number = _alongAxes[int(axis + 6)];
            if (motion == 0)
            {
                var off:Number = Math.max(0, Math.abs(at - begin - (square + 0.5) * _width) - _width / 2 - extent);
                _squared -= off * off;
                if (off > _box.maxDistance)
                {
                    _to = -1;
                }
                return;
            }
            var low:Number = (begin + square * _width - (at + extent)) / motion;
            var high:Number = (begin + (square + 1) * _width - (at - extent)) / motion;
            _from = Math.max(_from, Math.min(low, high));
            _to = Math.min(_to, Math.max(low, high));
        }

        // Finds which columns or rows the box passes over in the part of its motion, within a range. The place is its distance from the first.
        private function findRange(place:Number, extent:Number, motion:Number, first:int, last:int):void
        {
            var start:Number = place + _from * motion;
            var end:Number = place + _to * motion;
            _first = Math.max(first, Math.min(last + 1, Math.floor((Math.min(start, end) - extent) / _width)));
            _last = Math.max(first - 1, Math.min(last, Math.floor((Math.max(start, end) + extent) / _width)));
        }
    }
}
