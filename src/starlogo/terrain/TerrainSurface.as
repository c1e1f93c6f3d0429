package starlogo.terrain
{
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.ground.GroundBox;
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

        // The rectangle, as a box that passes over its cells.
        private var _box:GroundBox = new GroundBox();

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
            var firstColumn:int = clamp(Math.ceil((minX - grid.x) / grid.cellWidth), 0, grid.columns);
            var firstRow:int = clamp(Math.ceil((minY - grid.y) / grid.cellWidth), 0, grid.rows);
            var lastColumn:int = clamp(Math.floor((maxX - grid.x) / grid.cellWidth), -1, grid.columns - 1);
            var lastRow:int = clamp(Math.floor((maxY - grid.y) / grid.cellWidth), -1, grid.rows - 1);
            // A box from a quarter of a cell behind the first height to a quarter before the last one. So it passes over the blocks of these
            // heights and over the cells between them, and over no other.
            // With one column its half length is -0.25 cells. So it passes over exactly this column of blocks, and over no slopes. With none it is
            // -0.75, and it passes over nothing.
            var box:GroundBox = _box;
            box.x = grid.x + (firstColumn + lastColumn) / 2 * grid.cellWidth;
            box.y = grid.y + (firstRow + lastRow) / 2 * grid.cellWidth;
            box.halfX = ((lastColumn - firstColumn) / 2 - 0.25) * grid.cellWidth;
            box.halfY = ((lastRow - firstRow) / 2 - 0.25) * grid.cellWidth;
        }

        /**
         * Makes the triangles of the present heights, if the terrain has changed since the last call.
         *
         * @return whether it has changed
         */
        public function update():Boolean
        {
            if (_terrain.worldAgent.revision == _revision)
            {
                return false;
            }
            vertices.length = normals.length = triangles.length = 0;
            var source:GroundTriangles = new GroundTriangles();
            var triangle:GroundTriangle = new GroundTriangle();
            source.beginOver(_terrain.grid, _box);
            while (source.next(triangle))
            {
                addTriangle(triangle);
            }
            _revision = _terrain.worldAgent.revision;
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
