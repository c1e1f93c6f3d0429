package starlogo.terrain
{
    import starlogo.engine;

    use namespace engine;

    /**
     * The surface of a terrain as triangles, for drawing. Slopes have smooth normals, and columns have flat ones. Upright walls stand between
     * columns. Where the grid ends, walls go down to its lowest height.
     *
     * <p>The surface is made of faces: the cells of slopes, the tops of columns, and the walls. A face has four vertices of its own and two
     * triangles.</p>
     */
    public final class TerrainSurface
    {
        // The corners of a cell, counter-clockwise seen from above. Each side begins at the corner of its number.
        private static const CORNER_X:Vector.<int> = new <int>[0, 1, 1, 0];
        private static const CORNER_Y:Vector.<int> = new <int>[0, 0, 1, 1];

        // The ways from a cell to the neighbours beyond its sides.
        private static const BESIDE_X:Vector.<int> = new <int>[0, 1, 0, -1];
        private static const BESIDE_Y:Vector.<int> = new <int>[-1, 0, 1, 0];

        /** The vertices in the world: x, y and z of each. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** The direction out of the ground at each vertex: x, y and z, of length 1. */
        public var normals:Vector.<Number> = new Vector.<Number>();

        /** Three vertex indices for each triangle, counter-clockwise seen from outside of the ground. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        private var _grid:HeightGrid;
        private var _revision:int = -1;
        private var _isBlocky:Boolean;

        // How many cells the grid has along x and along y, and its lowest height.
        private var _columns:int;
        private var _rows:int;
        private var _lowest:Number;

        // The heights that are in the rectangle.
        private var _first:int;
        private var _firstRow:int;
        private var _last:int;
        private var _lastRow:int;

        /**
         * Begins without triangles. <code>update()</code> makes them. With a rectangle, the surface has only the cells of slopes that are
         * between heights in the rectangle, or the columns whose middles are in it.
         *
         * @param terrain the ground
         * @param minX the rectangle's least x; the rectangle may reach beyond the ground
         * @param minY its least y
         * @param maxX its greatest x
         * @param maxY its greatest y
         * @throws ArgumentError if the terrain is null
         */
        public function TerrainSurface(terrain:Terrain, minX:Number = Number.NEGATIVE_INFINITY, minY:Number = Number.NEGATIVE_INFINITY, maxX:Number = Infinity, maxY:Number = Infinity)
        {
            if (terrain == null)
            {
                throw new ArgumentError("there is no terrain to draw: null");
            }
            _grid = terrain.grid;
            _first = within(Math.ceil((minX - _grid.x) / _grid.cellWidth), 0, _grid.columns);
            _firstRow = within(Math.ceil((minY - _grid.y) / _grid.cellWidth), 0, _grid.rows);
            _last = within(Math.floor((maxX - _grid.x) / _grid.cellWidth), -1, _grid.columns - 1);
            _lastRow = within(Math.floor((maxY - _grid.y) / _grid.cellWidth), -1, _grid.rows - 1);
        }

        /**
         * Makes the triangles of the present heights, if the terrain has changed since the last call.
         *
         * @return whether it has changed
         */
        public function update():Boolean
        {
            if (_grid.revision == _revision && _grid.isBlocky == _isBlocky)
            {
                return false;
            }
            _revision = _grid.revision;
            _isBlocky = _grid.isBlocky;
            var beyond:int = _isBlocky ? 0 : 1;
            _columns = _grid.columns - beyond;
            _rows = _grid.rows - beyond;
            // the last level is one square
            _lowest = _grid.bounds[_grid.begins[_grid.levels]];
            vertices.length = normals.length = triangles.length = 0;
            for (var row:int = _firstRow; row <= _lastRow - beyond; row++)
            {
                for (var column:int = _first; column <= _last - beyond; column++)
                {
                    addCell(column, row);
                }
            }
            return true;
        }

        private static function within(value:Number, least:int, greatest:int):int
        {
            return Math.max(least, Math.min(greatest, value));
        }

        private function addCell(column:int, row:int):void
        {
            for (var corner:int = 0; corner < 4; corner++)
            {
                addTop(column, row, corner);
            }
            addTriangles();
            for (var side:int = 0; side < 4; side++)
            {
                var next:int = (side + 1) % 4;
                var low:Number = heightBeside(column + BESIDE_X[side], row + BESIDE_Y[side]);
                var height:Number = heightAt(column, row, side);
                var nextHeight:Number = heightAt(column, row, next);
                if (low < Math.max(height, nextHeight))
                {
                    addVertex(column, row, side, low, BESIDE_X[side], BESIDE_Y[side], 0);
                    addVertex(column, row, next, low, BESIDE_X[side], BESIDE_Y[side], 0);
                    addVertex(column, row, next, nextHeight, BESIDE_X[side], BESIDE_Y[side], 0);
                    addVertex(column, row, side, height, BESIDE_X[side], BESIDE_Y[side], 0);
                    addTriangles();
                }
            }
        }

        private function addTop(column:int, row:int, corner:int):void
        {
            var x:int = column + CORNER_X[corner];
            var y:int = row + CORNER_Y[corner];
            var slopeX:Number = slopeAt(y * _grid.columns + x, 1, x, _columns);
            var slopeY:Number = slopeAt(y * _grid.columns + x, _grid.columns, y, _rows);
            var length:Number = Math.sqrt(slopeX * slopeX + slopeY * slopeY + 1);
            addVertex(column, row, corner, heightAt(column, row, corner), -slopeX / length, -slopeY / length, 1 / length);
        }

        private function addVertex(column:int, row:int, corner:int, z:Number, normalX:Number, normalY:Number, normalZ:Number):void
        {
            // a column stands around its height
            var back:Number = _isBlocky ? 0.5 : 0;
            vertices.push(_grid.x + (column + CORNER_X[corner] - back) * _grid.cellWidth, _grid.y + (row + CORNER_Y[corner] - back) * _grid.cellWidth, z);
            normals.push(normalX, normalY, normalZ);
        }

        // Adds the two triangles of the last four vertices.
        private function addTriangles():void
        {
            var first:int = vertices.length / 3 - 4;
            triangles.push(first, first + 1, first + 2, first, first + 2, first + 3);
        }

        // The height of a cell at one of its corners.
        private function heightAt(column:int, row:int, corner:int):Number
        {
            return _grid.heights[_isBlocky ? row * _grid.columns + column : (row + CORNER_Y[corner]) * _grid.columns + column + CORNER_X[corner]];
        }

        // The lower edge of a wall towards this cell. Slopes have no walls between them.
        private function heightBeside(column:int, row:int):Number
        {
            if (column < 0 || row < 0 || column >= _columns || row >= _rows)
            {
                return _lowest;
            }
            return _isBlocky ? heightAt(column, row, 0) : Infinity;
        }

        // The slope along x or along y at a height, from the height before it to the one after it. The tops of columns have none.
        private function slopeAt(at:int, step:int, place:int, last:int):Number
        {
            if (_isBlocky)
            {
                return 0;
            }
            var before:int = place > 0 ? 1 : 0;
            var after:int = place < last ? 1 : 0;
            return (_grid.heights[at + after * step] - _grid.heights[at - before * step]) / (before + after) / _grid.cellWidth;
        }
    }
}
