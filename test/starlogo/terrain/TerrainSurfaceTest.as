package starlogo.terrain
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import support.RandomGround;
    import support.assertThrows;
    import support.create;

    /** The triangles of terrains, compared with what the terrains say of themselves. */
    public class TerrainSurfaceTest
    {
        private static const RANDOM_TERRAINS:int = 40;

        private var _random:SeededRandom = new SeededRandom(43);

        [Test]
        public function itEnclosesTheGround():void
        {
            for each (var terrain:Terrain in someTerrains())
            {
                var surface:TerrainSurface = surfaceOf(terrain);
                var lowest:Number = lowestOf(terrain);
                var expected:Number = volumeOf(terrain, lowest);
                // the volume by the triangles' parts along each axis: a hole or a triangle the wrong way round changes one of the three
                for (var axis:int = 0; axis < 3; axis++)
                {
                    var origin:Number = axis == 0 ? terrain.x : axis == 1 ? terrain.y : lowest;
                    var volume:Number = 0;
                    for (var i:int = 0; i < surface.triangles.length; i += 3)
                    {
                        volume += areaOf(surface, i, axis) * (middleOf(surface, i, axis) - origin);
                    }
                    var size:Number = terrain.columns * terrain.rows * terrain.cellWidth * terrain.cellWidth * (1 + greatestOf(terrain) - lowest);
                    assertTrue(axis + ": " + volume + ", not " + expected, Math.abs(volume - expected) < 1e-6 * size);
                }
            }
        }

        [Test]
        public function normalsPointOutAndTopsAreOnTheGround():void
        {
            var walls:int = 0;
            var smooth:int = 0;
            for each (var terrain:Terrain in someTerrains())
            {
                var surface:TerrainSurface = surfaceOf(terrain);
                assertEquals(surface.vertices.length, surface.normals.length);
                for (var i:int = 0; i < surface.triangles.length; i++)
                {
                    var at:int = 3 * surface.triangles[i];
                    var first:int = i - i % 3;
                    var along:Number = 0;
                    var squares:Number = 0;
                    for (var axis:int = 0; axis < 3; axis++)
                    {
                        along += areaOf(surface, first, axis) * surface.normals[at + axis];
                        squares += surface.normals[at + axis] * surface.normals[at + axis];
                    }
                    var vertex:String = "vertex " + surface.triangles[i] + " of " + terrain + (terrain.isBlocky ? ", blocky" : "");
                    assertTrue("its normal's squared length is " + squares + ": " + vertex, Math.abs(squares - 1) < 1e-9);
                    assertTrue("a steep cell may face away from the mean of its neighbours, but walls and columns may not: " + along + ", " + vertex,
                            along >= 0 || !terrain.isBlocky && surface.normals[at + 2] > 0);
                    walls += surface.normals[at + 2] == 0 ? 1 : 0;
                    smooth += surface.normals[at + 2] > 0 && surface.normals[at + 2] < 1 ? 1 : 0;
                    if (!terrain.isBlocky && surface.normals[at + 2] > 0)
                    {
                        assertEquals(heightOf(terrain, surface.vertices[at], surface.vertices[at + 1]), surface.vertices[at + 2]);
                    }
                }
            }
            assertTrue(walls > 1000 && smooth > 1000);
        }

        [Test]
        public function aSlopeHasItsNormal():void
        {
            var terrain:Terrain = new Terrain(4, 3, 2);
            for (var i:int = 0; i < 12; i++)
            {
                terrain.setHeight(i % 4, i / 4, 3 * (i % 4) - int(i / 4));
            }
            var surface:TerrainSurface = surfaceOf(terrain);
            for (i = 0; i < surface.normals.length; i += 3)
            {
                if (surface.normals[i + 2] > 0)
                {
                    assertTrue(Math.abs(surface.normals[i] / surface.normals[i + 2] + 1.5) < 1e-12);
                    assertTrue(Math.abs(surface.normals[i + 1] / surface.normals[i + 2] - 0.5) < 1e-12);
                }
            }
        }

        [Test]
        public function rectanglesTogetherAreTheWhole():void
        {
            for each (var terrain:Terrain in someTerrains())
            {
                var cutX:Number = terrain.x + (_random.integer(0, terrain.columns - 1) + (terrain.isBlocky ? 0.5 : 0)) * terrain.cellWidth;
                var cutY:Number = terrain.y + (_random.integer(0, terrain.rows - 1) + (terrain.isBlocky ? 0.5 : 0)) * terrain.cellWidth;
                // slopes need the heights at the cut on both sides
                var more:Number = terrain.isBlocky ? 0 : 0.1 * terrain.cellWidth;
                var faces:Array = facesOf(new TerrainSurface(terrain, -Infinity, -Infinity, cutX + more, cutY + more));
                faces = faces.concat(facesOf(new TerrainSurface(terrain, cutX - more, -Infinity, Infinity, cutY + more)));
                faces = faces.concat(facesOf(new TerrainSurface(terrain, -Infinity, cutY - more, cutX + more, Infinity)));
                faces = faces.concat(facesOf(new TerrainSurface(terrain, cutX - more, cutY - more)));
                assertEquals(facesOf(new TerrainSurface(terrain)).sort().join("\n"), faces.sort().join("\n"));
            }
        }

        [Test]
        public function aMountainFarFromTheRectangleChangesNothing():void
        {
            var terrain:Terrain = new Terrain(201, 201, 1e-6);
            terrain.isBlocky = true;
            terrain.setHeight(0, 0, 1e9);
            var surface:TerrainSurface = new TerrainSurface(terrain, 49.5e-6, 49.5e-6, 60.5e-6, 60.5e-6);
            surface.update();
            assertEquals("11 by 11 blocks", 3 * 2 * 121, surface.triangles.length);
        }

        [Test]
        public function eachTriangleHasAnArea():void
        {
            var terrain:Terrain = new Terrain(5, 5);
            terrain.setHeight(0, 0, 1);
            terrain.setHeight(2, 0, 1);
            var surface:TerrainSurface = surfaceOf(terrain);
            assertEquals("32 on top; a side of the first peak on two borders, and both of the second one", 3 * (32 + 4), surface.triangles.length);
            for (var i:int = 0; i < surface.triangles.length; i += 3)
            {
                assertTrue(areaOf(surface, i, 0) != 0 || areaOf(surface, i, 1) != 0 || areaOf(surface, i, 2) != 0);
            }
        }

        [Test]
        public function itFollowsTheTerrain():void
        {
            var terrain:Terrain = new Terrain(5, 4);
            var surface:TerrainSurface = new TerrainSurface(terrain);
            assertEquals(0, surface.triangles.length);
            assertTrue(surface.update());
            assertFalse(surface.update());
            assertEquals("flat ground has no walls", 6 * 4 * 3, surface.triangles.length);
            terrain.setHeight(2, 2, 1);
            assertTrue(surface.update());
            terrain.isBlocky = true;
            assertTrue(surface.update());
            assertEquals("a wall on each side", 6 * (5 * 4 + 4), surface.triangles.length);
            terrain.setHeight(2, 2, -1);
            assertTrue(surface.update());
            assertEquals("and around all", 6 * (5 * 4 + 4 + 2 * 5 + 2 * 4), surface.triangles.length);
            assertThrows(ArgumentError, /terrain must/, create, TerrainSurface, null);
        }

        private function someTerrains():Vector.<Terrain>
        {
            var terrains:Vector.<Terrain> = new Vector.<Terrain>();
            for (var i:int = 0; i < RANDOM_TERRAINS; i++)
            {
                terrains.push(RandomGround.make(RandomGround.KINDS[i % RandomGround.KINDS.length], _random));
                terrains[i].isBlocky = i % 16 < 8;
            }
            return terrains;
        }

        private static function surfaceOf(terrain:Terrain):TerrainSurface
        {
            var surface:TerrainSurface = new TerrainSurface(terrain);
            surface.update();
            return surface;
        }

        private static function facesOf(surface:TerrainSurface):Array
        {
            surface.update();
            var faces:Array = [];
            for (var i:int = 0; i < surface.vertices.length; i += 9)
            {
                faces.push(surface.vertices.slice(i, i + 9).concat(surface.normals.slice(i, i + 9)).join());
            }
            return faces;
        }

        // The area of a triangle as seen along an axis; negative if it is seen from inside.
        private static function areaOf(surface:TerrainSurface, triangle:int, axis:int):Number
        {
            var next:int = (axis + 1) % 3;
            var last:int = (axis + 2) % 3;
            var a:int = 3 * surface.triangles[triangle];
            var b:int = 3 * surface.triangles[triangle + 1];
            var c:int = 3 * surface.triangles[triangle + 2];
            var at:Vector.<Number> = surface.vertices;
            return ((at[b + next] - at[a + next]) * (at[c + last] - at[a + last]) - (at[b + last] - at[a + last]) * (at[c + next] - at[a + next])) / 2;
        }

        private static function middleOf(surface:TerrainSurface, triangle:int, axis:int):Number
        {
            return (surface.vertices[3 * surface.triangles[triangle] + axis] + surface.vertices[3 * surface.triangles[triangle + 1] + axis]
                    + surface.vertices[3 * surface.triangles[triangle + 2] + axis]) / 3;
        }

        // The volume of the ground above its lowest height.
        private static function volumeOf(terrain:Terrain, lowest:Number):Number
        {
            var sum:Number = 0;
            for (var row:int = 0; row < terrain.rows; row++)
            {
                for (var column:int = 0; column < terrain.columns; column++)
                {
                    if (terrain.isBlocky && !terrain.isHole(column, row))
                    {
                        sum += terrain.getHeight(column, row) - lowest;
                    }
                    else if (!terrain.isBlocky && column > 0 && row > 0 && !terrain.isHole(column - 1, row - 1))
                    {
                        // two prisms, which share the diagonal's ends
                        sum += (terrain.getHeight(column - 1, row - 1) + terrain.getHeight(column, row)) / 3
                            + (terrain.getHeight(column, row - 1) + terrain.getHeight(column - 1, row)) / 6 - lowest;
                    }
                }
            }
            return sum * terrain.cellWidth * terrain.cellWidth;
        }

        private static function lowestOf(terrain:Terrain):Number
        {
            var lowest:Number = Infinity;
            for (var i:int = 0; i < terrain.columns * terrain.rows; i++)
            {
                lowest = Math.min(lowest, terrain.getHeight(i % terrain.columns, i / terrain.columns));
            }
            return lowest;
        }

        private static function greatestOf(terrain:Terrain):Number
        {
            var greatest:Number = -Infinity;
            for (var i:int = 0; i < terrain.columns * terrain.rows; i++)
            {
                greatest = Math.max(greatest, terrain.getHeight(i % terrain.columns, i / terrain.columns));
            }
            return greatest;
        }

        private static function heightOf(terrain:Terrain, x:Number, y:Number):Number
        {
            return terrain.getHeight(Math.round((x - terrain.x) / terrain.cellWidth), Math.round((y - terrain.y) / terrain.cellWidth));
        }
    }
}
