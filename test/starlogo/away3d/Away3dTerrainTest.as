package starlogo.away3d
{
    import away3d.core.base.ISubGeometry;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.TerrainSurface;
    import support.assertThrows;
    import support.create;

    /** The ground as the real Away3D draws it. */
    public class Away3dTerrainTest
    {
        private var _terrain:Terrain;

        [Before]
        public function raise():void
        {
            _terrain = new Terrain(9, 7, 0.5, -2, 3);
            _terrain.raiseMound(0, 4, 3, 2);
            _terrain.raiseWall(2, 6, 1);
        }

        [Test]
        public function itIsTheSurfaceInAway3dsAxes():void
        {
            var ground:Away3dTerrain = new Away3dTerrain(_terrain);
            assertStrictlyEquals(_terrain, ground.terrain);
            for each (var isBlocky:Boolean in [false, true])
            {
                assertEquals(isBlocky, ground.update() || isBlocky);
                _terrain.isBlocky = isBlocky;
                ground.update();
                var surface:TerrainSurface = new TerrainSurface(_terrain);
                surface.update();
                assertEquals(1, ground.subMeshes.length);
                var part:ISubGeometry = ground.subMeshes[0].subGeometry;
                assertEquals(surface.triangles.length / 3, part.numTriangles);
                assertEquals(surface.vertices.length / 3, part.numVertices);
                for (var i:int = 0; i < part.numVertices; i++)
                {
                    assertEquals(surface.vertices.slice(3 * i, 3 * i + 3).join(), swappedAt(part.vertexData, i));
                    assertEquals(surface.normals.slice(3 * i, 3 * i + 3).join(), swappedAt(part.vertexNormalData, i));
                }
            }
        }

        [Test]
        public function itShowsItsUpperSide():void
        {
            var ground:Away3dTerrain = new Away3dTerrain(_terrain);
            for each (var isBlocky:Boolean in [false, true])
            {
                _terrain.isBlocky = isBlocky;
                ground.update();
                var part:ISubGeometry = ground.geometry.subGeometries[0];
                for (var i:int = 0; i < part.indexData.length; i += 3)
                {
                    var a:Vector3D = pointAt(part.vertexData, part.indexData[i]);
                    var b:Vector3D = pointAt(part.vertexData, part.indexData[i + 1]);
                    var c:Vector3D = pointAt(part.vertexData, part.indexData[i + 2]);
                    // as Away3D itself finds the normals of faces
                    var out:Vector3D = b.subtract(a).crossProduct(c.subtract(a));
                    var isPoint:Boolean = out.length < 1e-9;
                    assertTrue(isPoint || out.dotProduct(pointAt(part.vertexNormalData, part.indexData[i])) > 0);
                }
            }
        }

        [Test]
        public function itFollowsTheHeights():void
        {
            var ground:Away3dTerrain = new Away3dTerrain(_terrain);
            assertFalse(ground.update());
            _terrain.setHeight(4, 3, 7);
            assertTrue(ground.update());
            assertFalse(ground.update());
            assertEquals(7, ground.maxY);
            assertEquals("x", "-2,2", [ground.minX, ground.maxX].join());
            assertEquals("z", "3,6", [ground.minZ, ground.maxZ].join());
            _terrain.reset();
            ground.update();
            assertEquals("without walls", 2 * 8 * 6, ground.geometry.subGeometries[0].numTriangles);
            assertEquals(0, ground.maxY);
        }

        [Test]
        public function aTextureLiesOverTheGrid():void
        {
            var part:ISubGeometry = new Away3dTerrain(_terrain).geometry.subGeometries[0];
            var corners:int = 0;
            for (var i:int = 0; i < part.numVertices; i++)
            {
                var place:Vector3D = pointAt(part.vertexData, i);
                assertTrue(Math.abs(part.UVData[2 * i] - (place.x + 2) / 4) < 1e-9);
                assertTrue(Math.abs(part.UVData[2 * i + 1] - (6 - place.z) / 3) < 1e-9);
                corners += part.UVData[2 * i] % 1 == 0 && part.UVData[2 * i + 1] % 1 == 0 ? 1 : 0;
            }
            assertTrue(corners >= 4);
        }

        [Test]
        public function aLargeGroundHasSeveralParts():void
        {
            _terrain = new Terrain(140, 130);
            _terrain.raiseMound(70, 60, 100, 9);
            var ground:Away3dTerrain = new Away3dTerrain(_terrain);
            var triangles:int = 0;
            for each (var part:ISubGeometry in ground.geometry.subGeometries)
            {
                assertTrue(part.numVertices + " vertices", part.numVertices < 65536 && part.numVertices * 3 == part.vertexData.length);
                assertTrue(Math.max.apply(null, toArray(part.indexData.slice(-6))) < part.numVertices);
                triangles += part.numTriangles;
            }
            assertEquals(2 * 139 * 129, triangles);
            assertEquals(2, ground.subMeshes.length);
        }

        [Test]
        public function thereMustBeATerrain():void
        {
            assertThrows(ArgumentError, /terrain must not be null/, create, Away3dTerrain, null);
        }

        private static function pointAt(numbers:Vector.<Number>, index:int):Vector3D
        {
            return new Vector3D(numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]);
        }

        private static function swappedAt(numbers:Vector.<Number>, index:int):String
        {
            return [numbers[3 * index], numbers[3 * index + 2], numbers[3 * index + 1]].join();
        }

        private static function toArray(indices:Vector.<uint>):Array
        {
            var array:Array = [];
            for each (var index:uint in indices)
            {
                array.push(index);
            }
            return array;
        }
    }
}
