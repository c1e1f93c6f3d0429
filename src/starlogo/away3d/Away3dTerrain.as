package starlogo.away3d
{
    import away3d.core.base.Geometry;
    import away3d.core.base.SubGeometry;
    import away3d.entities.Mesh;
    import away3d.materials.MaterialBase;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.TerrainSurface;

    /**
     * Draws the surface of a terrain in an Away3D scene, slopes or blocks. The parent must be the land, as for an Away3dAgentBinding's
     * object, and the mesh must not be moved in it.
     *
     * <p>Slopes have smooth normals, and blocks have flat ones. Where the grid ends, walls go down to its lowest height. A texture lies over
     * the whole grid, seen from above: the top of the picture has the greatest y.</p>
     *
     * <listing version="3.0">
     * var ground:Away3dTerrain = new Away3dTerrain(terrain, material);
     * scene.addChild(ground);
     * ground.update();     // every frame
     * </listing>
     */
    public final class Away3dTerrain extends Mesh
    {
        // A SubGeometry has at most 65535 vertices.
        private static const MAX_TRIANGLES:int = 21845;

        private var _terrain:Terrain;
        private var _surface:TerrainSurface;

        /**
         * Creates the mesh with the present heights.
         *
         * @param terrain the ground
         * @param material as for a Mesh
         * @throws ArgumentError if the terrain is null
         */
        public function Away3dTerrain(terrain:Terrain, material:MaterialBase = null)
        {
            super(new Geometry(), material);
            _terrain = terrain;
            _surface = new TerrainSurface(terrain);
            update();
        }

        /** The ground. */
        public function get terrain():Terrain
        {
            return _terrain;
        }

        /**
         * Follows the terrain: its heights, and whether it is blocks. If nothing has changed, it does nothing.
         *
         * @return whether something has changed
         */
        public function update():Boolean
        {
            if (!_surface.update())
            {
                return false;
            }
            geometry.dispose();
            var triangles:int = _surface.triangles.length / 3;
            for (var first:int = 0; first < triangles; first += MAX_TRIANGLES)
            {
                geometry.addSubGeometry(partOf(first, Math.min(triangles, first + MAX_TRIANGLES)));
            }
            return true;
        }

        private function partOf(first:int, end:int):SubGeometry
        {
            var vertices:Vector.<Number> = swap(_surface.vertices.slice(9 * first, 9 * end));
            var part:SubGeometry = new SubGeometry();
            part.updateVertexData(vertices);
            part.updateVertexNormalData(swap(_surface.normals.slice(9 * first, 9 * end)));
            part.updateUVData(findUVs(vertices));
            // Each triangle has vertices of its own, so the indices are the first ones. They are reversed, because swapped axes mirror triangles.
            part.updateIndexData(_surface.triangles.slice(0, 3 * (end - first)).reverse());
            return part;
        }

        private function findUVs(vertices:Vector.<Number>):Vector.<Number>
        {
            var uvs:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                uvs.push((vertices[i] - _terrain.x) / (_terrain.columns - 1) / _terrain.cellWidth,
                        1 - (vertices[i + 2] - _terrain.y) / (_terrain.rows - 1) / _terrain.cellWidth);
            }
            return uvs;
        }

        private static function swap(numbers:Vector.<Number>):Vector.<Number>
        {
            for (var i:int = 0; i < numbers.length; i += 3)
            {
                var y:Number = numbers[i + 1];
                numbers[i + 1] = numbers[i + 2];
                numbers[i + 2] = y;
            }
            return numbers;
        }
    }
}
