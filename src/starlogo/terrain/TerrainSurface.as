package starlogo.terrain
{
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.ground.GroundPoint;
    import starlogo.ground.GroundTriangle;
    import starlogo.ground.GroundTriangles;
    import starlogo.ground.HeightGrid;

    use namespace engine;

    /**
     * The surface of a terrain as triangles, for drawing: those that agents are tested with. Slopes have smooth normals, and blocks have flat
     * ones. Upright walls stand between blocks. Where the grid ends, and around holes, walls go down to the lowest height.
     *
     * <p>Each triangle has three vertices of its own.</p>
     */
    public final class TerrainSurface
    {
        /** The vertices in the world: x, y and z of each. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** The direction out of the ground at each vertex: x, y and z, of length 1. */
        public var normals:Vector.<Number> = new Vector.<Number>();

        /** Three vertex indices for each triangle, counter-clockwise seen from outside of the ground. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        private var _revision:int = -1;
        private var _terrain:Terrain;

        // The columns and rows of the first and the last height in the rectangle.
        private var _first:GroundPoint = new GroundPoint();
        private var _last:GroundPoint = new GroundPoint();

        /**
         * Begins without triangles. <code>update()</code> makes them. With a rectangle, the surface has only the cells of slopes that are
         * between heights in the rectangle, or the blocks whose middles are in it.
         *
         * @param terrain the ground
         * @param minX the rectangle's least x; the rectangle may reach beyond the ground
         * @param minY its least y
         * @param maxX its greatest x
         * @param maxY its greatest y
         * @throws ArgumentError if the terrain is null
         * @throws RangeError if a border is not a number
         */
        public function TerrainSurface(terrain:Terrain, minX:Number = Number.NEGATIVE_INFINITY, minY:Number = Number.NEGATIVE_INFINITY,
                maxX:Number = Infinity, maxY:Number = Infinity)
        {
            requireGiven("terrain", terrain);
            if (isNaN(minX) || isNaN(minY) || isNaN(maxX) || isNaN(maxY))
            {
                throw new RangeError("the borders of a rectangle must be numbers, not " + [minX, minY, maxX, maxY]);
            }
            var grid:HeightGrid = terrain.grid;
            _terrain = terrain;
            _first.column = clamp(Math.ceil((minX - grid.x) / grid.cellWidth), 0, grid.columns);
            _first.row = clamp(Math.ceil((minY - grid.y) / grid.cellWidth), 0, grid.rows);
            _last.column = clamp(Math.floor((maxX - grid.x) / grid.cellWidth), -1, grid.columns - 1);
            _last.row = clamp(Math.floor((maxY - grid.y) / grid.cellWidth), -1, grid.rows - 1);
        }

        /**
         * Makes the triangles of the present heights, if heights or holes of the terrain have been set since the last call, or its agent has.
         *
         * @return whether it has made them
         */
        public function update():Boolean
        {
            if (_terrain.environmentAgent.revision == _revision)
            {
                return false;
            }
            vertices.length = normals.length = triangles.length = 0;
            var source:GroundTriangles = new GroundTriangles();
            var triangle:GroundTriangle = new GroundTriangle();
            // a cell of slopes ends at the next heights
            var next:int = _terrain.isBlocky ? 0 : 1;
            source.beginWithCells(_terrain.grid, _first.column, _first.row, _last.column - next, _last.row - next);
            while (source.next(triangle))
            {
                addTriangle(triangle);
            }
            _revision = _terrain.environmentAgent.revision;
            return true;
        }

        private static function clamp(value:Number, min:int, max:int):int
        {
            return Math.max(min, Math.min(max, value));
        }

        private function addTriangle(triangle:GroundTriangle):void
        {
            var corners:Vector.<Number> = triangle.corners;
            var x:Number = corners[3] - corners[0];
            var y:Number = corners[4] - corners[1];
            for (var i:int = 0; i < 9; i += 3)
            {
                triangles.push(vertices.length / 3);
                vertices.push(corners[i], corners[i + 1], corners[i + 2]);
                if (triangle.isWall)
                {
                    var width:Number = Math.abs(x) + Math.abs(y);
                    normals.push(y / width, -x / width, 0);
                }
                else
                {
                    addNormal((corners[i] - _terrain.x) / _terrain.cellWidth, (corners[i + 1] - _terrain.y) / _terrain.cellWidth);
                }
            }
        }

        // Adds the normal of a top at a place in cells. Slopes have it from the heights around the place.
        private function addNormal(x:Number, y:Number):void
        {
            var column:int = Math.round(x);
            var row:int = Math.round(y);
            var grid:HeightGrid = _terrain.grid;
            var at:int = row * grid.columns + column;
            var slopeX:Number = grid.isBlocky ? 0 : slopeAt(at, 1, column, grid.columns - 1);
            var slopeY:Number = grid.isBlocky ? 0 : slopeAt(at, grid.columns, row, grid.rows - 1);
            var length:Number = Math.sqrt(slopeX * slopeX + slopeY * slopeY + 1);
            normals.push(-slopeX / length, -slopeY / length, 1 / length);
        }

        // The slope along x or along y at a height, from the height before it to the one after it.
        private function slopeAt(at:int, step:int, place:int, last:int):Number
        {
            var before:int = place > 0 ? 1 : 0;
            var after:int = place < last ? 1 : 0;
            var heights:Vector.<Number> = _terrain.grid.heights;
            return (heights[at + after * step] - heights[at - before * step]) / (before + after) / _terrain.grid.cellWidth;
        }
    }
}
