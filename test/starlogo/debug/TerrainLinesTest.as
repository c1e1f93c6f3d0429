package starlogo.debug
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.terrain.Terrain;
    import support.RandomGround;
    import support.assertThrows;

    /** The lines of a terrain, compared with what it says of itself. */
    public class TerrainLinesTest
    {
        private static const RANDOM_TERRAINS:int = 60;

        private var _random:SeededRandom = new SeededRandom(41);

        [Test]
        public function slopesAreTheEdgesOfTheirTriangles():void
        {
            for each (var terrain:Terrain in someTerrains(false))
            {
                var lines:Vector.<Number> = allLines(terrain);
                var columns:int = terrain.columns;
                var rows:int = terrain.rows;
                assertEquals(6 * ((columns - 1) * rows + columns * (rows - 1) + (columns - 1) * (rows - 1)), lines.length);
                assertNoneTwice(lines);
                for (var i:int = 0; i < lines.length; i += 6)
                {
                    // between the ends too: no other cut of a cell in two has its diagonal on the surface
                    for (var part:Number = 0; part <= 1; part += 0.25)
                    {
                        var x:Number = lines[i] + part * (lines[i + 3] - lines[i]);
                        var y:Number = lines[i + 1] + part * (lines[i + 4] - lines[i + 1]);
                        var z:Number = lines[i + 2] + part * (lines[i + 5] - lines[i + 2]);
                        var off:Number = Math.abs(z - heightNear(terrain, x, y));
                        assertTrue("a line is " + off + " off the surface", off < 1e-4);
                    }
                }
            }
        }

        [Test]
        public function columnsAreTheEdgesOfTheirTopsAndWalls():void
        {
            var uprights:int = 0;
            for each (var terrain:Terrain in someTerrains(true))
            {
                var found:Object = assertNoneTwice(allLines(terrain));
                var count:int = 0;
                for (var row:int = 0; row <= terrain.rows; row++)
                {
                    for (var column:int = 0; column <= terrain.columns; column++)
                    {
                        var all:Array = [heightOf(terrain, column, row), heightOf(terrain, column - 1, row), heightOf(terrain, column, row - 1),
                                heightOf(terrain, column - 1, row - 1)];
                        count += findTop(found, terrain, column, row, 1, 0, all[0]) + findTop(found, terrain, column, row, 0, 1, all[0]);
                        count += all[2] != all[0] ? findTop(found, terrain, column, row, 1, 0, all[2]) : 0;
                        count += all[1] != all[0] ? findTop(found, terrain, column, row, 0, 1, all[1]) : 0;
                        all = all.filter(function(height:Number, ...rest):Boolean
                            {
                                return !isNaN(height);
                            }).sort(Array.NUMERIC);
                        if (all[0] < all[all.length - 1])
                        {
                            var corner:Array = [terrain.x + (column - 0.5) * terrain.cellWidth, terrain.y + (row - 0.5) * terrain.cellWidth];
                            assertTrue(found[keyOf(corner.concat(all[0], corner, all[all.length - 1]))]);
                            count++;
                            uprights++;
                        }
                    }
                }
                assertEquals("there are no others", count, sizeOf(found));
            }
            assertTrue(uprights > 500);
        }

        [Test]
        public function aRectangleIsAsAGroundOfItsHeightsAlone():void
        {
            var some:int = 0;
            for each (var isBlocky:Boolean in [false, true])
            {
                for each (var terrain:Terrain in someTerrains(isBlocky))
                {
                    var first:int = _random.integer(0, terrain.columns - 2);
                    var firstRow:int = _random.integer(0, terrain.rows - 2);
                    var columns:int = _random.integer(2, terrain.columns - first);
                    var rows:int = _random.integer(2, terrain.rows - firstRow);
                    var width:Number = terrain.cellWidth;
                    var part:Terrain = new Terrain(columns, rows, width, terrain.x + first * width, terrain.y + firstRow * width);
                    part.isBlocky = isBlocky;
                    for (var i:int = 0; i < columns * rows; i++)
                    {
                        part.setHeight(i % columns, i / columns, terrain.getHeight(first + i % columns, firstRow + int(i / columns)));
                    }
                    // up to nearly the next heights
                    var lines:Vector.<Number> = Wireframes.ofTerrain(terrain, part.x - 0.9 * width, part.y - 0.1 * width, part.x + (columns - 0.9) * width,
                            part.y + (rows - 0.1) * width);
                    var expected:Object = assertNoneTwice(allLines(part));
                    var found:Object = assertNoneTwice(lines);
                    assertEquals(sizeOf(expected), sizeOf(found));
                    for (var key:String in expected)
                    {
                        assertTrue(key, found[key]);
                    }
                    some += columns < terrain.columns ? 1 : 0;
                }
            }
            assertTrue(some > RANDOM_TERRAINS);
        }

        [Test]
        public function aRectangleMayBeAnywhere():void
        {
            var terrain:Terrain = new Terrain(4, 3, 1, 10, 20);
            var all:int = allLines(terrain).length;
            assertEquals(all, Wireframes.ofTerrain(terrain, -1e300, -1e300, 1e300, 1e300).length);
            assertEquals(all, Wireframes.ofTerrain(terrain, 10, 20, 13, 22).length);
            for each (var rectangle:Array in [[14, -Infinity, Infinity, Infinity], [1e300, 0, 1e301, 30], [Infinity, 0, Infinity, 30], [-1e301, 0, -1e300, 30],
                        [0, 0, 9.9, 30], [0, -Infinity, 30, -Infinity], [0, 1e10, 30, 2e10], [12, 20, 11, 22], [10.1, 20, 10.9, 22]])
            {
                assertEquals(rectangle.join(), 0, Wireframes.ofTerrain(terrain, rectangle[0], rectangle[1], rectangle[2], rectangle[3]).length);
            }
            assertEquals("one height has no slope", 0, Wireframes.ofTerrain(terrain, 11, 21, 11, 21).length);
            terrain.isBlocky = true;
            assertEquals("but a column", 4 * 6, Wireframes.ofTerrain(terrain, 11, 21, 11, 21).length);
            assertEquals("9,10.5,20.5,0", Wireframes.ofTerrain(terrain, 11, 21, 11, 21, new <Number>[9]).slice(0, 4).join());
            assertThrows(ArgumentError, /no terrain to draw/, Wireframes.ofTerrain, null, 0, 0, 1, 1);
        }

        private static function allLines(terrain:Terrain):Vector.<Number>
        {
            return Wireframes.ofTerrain(terrain, -Infinity, -Infinity, Infinity, Infinity);
        }

        private function someTerrains(areBlocky:Boolean):Vector.<Terrain>
        {
            var terrains:Vector.<Terrain> = new Vector.<Terrain>();
            for (var i:int = 0; i < RANDOM_TERRAINS; i++)
            {
                var kind:String = RandomGround.KINDS[i % RandomGround.KINDS.length];
                var terrain:Terrain = RandomGround.make(kind, _random);
                terrain.isBlocky = areBlocky;
                terrains.push(terrain);
            }
            return terrains;
        }

        // 1 if the edge of a top has to be there, and is.
        private static function findTop(found:Object, terrain:Terrain, column:int, row:int, columns:int, rows:int, height:Number):int
        {
            if (isNaN(height))
            {
                return 0;
            }
            var x:Number = terrain.x + (column - 0.5) * terrain.cellWidth;
            var y:Number = terrain.y + (row - 0.5) * terrain.cellWidth;
            assertTrue(found[keyOf([x, y, height, x + columns * terrain.cellWidth, y + rows * terrain.cellWidth, height])]);
            return 1;
        }

        // Rounding may have put a place at the border outside.
        private static function heightNear(terrain:Terrain, x:Number, y:Number):Number
        {
            var middleX:Number = terrain.x + (terrain.columns - 1) / 2 * terrain.cellWidth;
            var middleY:Number = terrain.y + (terrain.rows - 1) / 2 * terrain.cellWidth;
            return terrain.heightAt(x + 1e-9 * (middleX - x), y + 1e-9 * (middleY - y));
        }

        private static function heightOf(terrain:Terrain, column:int, row:int):Number
        {
            return terrain.heightAt(terrain.x + column * terrain.cellWidth, terrain.y + row * terrain.cellWidth);
        }

        // Lines as the keys of an object, whichever way they go.
        private static function assertNoneTwice(lines:Vector.<Number>):Object
        {
            var keys:Object = {};
            for (var i:int = 0; i < lines.length; i += 6)
            {
                var there:Array = [lines[i], lines[i + 1], lines[i + 2], lines[i + 3], lines[i + 4], lines[i + 5]];
                var key:String = keyOf(there);
                assertTrue("a line twice: " + key, !keys[key]);
                keys[key] = keys[keyOf(there.slice(3).concat(there.slice(0, 3)))] = true;
            }
            return keys;
        }

        private static function keyOf(numbers:Array):String
        {
            return numbers.map(function(number:Number, ...rest):Number
                {
                    return round(number);
                }).join();
        }

        // As a whole number, of which -0 is not another.
        private static function round(number:Number):Number
        {
            return Math.round(number * 1e6) + 0;
        }

        private static function sizeOf(keys:Object):int
        {
            var count:int = 0;
            for (var key:String in keys)
            {
                count++;
            }
            return count / 2;
        }
    }
}
