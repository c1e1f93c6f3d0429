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
        public function theyAreTheEdgesOfTrianglesOfTopsAndWalls():void
        {
            var parts:int = 0;
            for each (var isBlocky:Boolean in [false, true])
            {
                for each (var terrain:Terrain in someTerrains(isBlocky))
                {
                    var first:int = _random.integer(0, terrain.columns - 2);
                    var firstRow:int = _random.integer(0, terrain.rows - 2);
                    var last:int = _random.integer(first + 1, terrain.columns - 1);
                    var lastRow:int = _random.integer(firstRow + 1, terrain.rows - 1);
                    assertLines(allLines(terrain), edgesOf(terrain, 0, 0, terrain.columns - 1, terrain.rows - 1));
                    // up to nearly the next heights
                    var width:Number = terrain.cellWidth;
                    assertLines(Wireframes.ofTerrain(terrain, terrain.x + (first - 0.9) * width, terrain.y + (firstRow - 0.1) * width,
                                terrain.x + (last + 0.1) * width, terrain.y + (lastRow + 0.9) * width), edgesOf(terrain, first, firstRow, last, lastRow));
                    parts += last - first < terrain.columns - 1 ? 1 : 0;
                }
            }
            assertTrue(parts > RANDOM_TERRAINS);
        }

        private static function assertLines(lines:Vector.<Number>, expected:Object):void
        {
            var found:Object = assertNoneTwice(lines);
            for (var key:String in expected)
            {
                assertTrue(key, found[key]);
            }
            assertEquals("there are no others", sizeOf(expected), sizeOf(found));
        }

        // The lines that have to be there, as the keys of an object, in both directions.
        private static function edgesOf(terrain:Terrain, first:int, firstRow:int, last:int, lastRow:int):Object
        {
            var edges:Object = {};
            var beyond:int = terrain.isBlocky ? 0 : 1;
            var lowest:Number = Infinity;
            for (var i:int = 0; i < terrain.columns * terrain.rows; i++)
            {
                lowest = Math.min(lowest, terrain.getHeight(i % terrain.columns, i / terrain.columns));
            }
            for (var row:int = firstRow; row <= lastRow - beyond; row++)
            {
                for (var column:int = first; column <= last - beyond; column++)
                {
                    if (terrain.isHole(column, row))
                    {
                        continue;
                    }
                    addEdge(edges, cornerOf(terrain, column, row, 0, 0), cornerOf(terrain, column, row, 1, 1));
                    addSide(edges, terrain, column, row, 0, 0, 1, 0, row == 0, column, row - 1, lowest);
                    addSide(edges, terrain, column, row, 1, 1, 0, 1, row == terrain.rows - 1 - beyond, column, row + 1, lowest);
                    addSide(edges, terrain, column, row, 0, 1, 0, 0, column == 0, column - 1, row, lowest);
                    addSide(edges, terrain, column, row, 1, 0, 1, 1, column == terrain.columns - 1 - beyond, column + 1, row, lowest);
                }
            }
            return edges;
        }

        // A side of a top, and of the wall under it.
        private static function addSide(edges:Object, terrain:Terrain, column:int, row:int, x:int, y:int, toX:int, toY:int, isBorder:Boolean,
                besideColumn:int, besideRow:int, lowest:Number):void
        {
            var from:Array = cornerOf(terrain, column, row, x, y);
            var to:Array = cornerOf(terrain, column, row, toX, toY);
            addEdge(edges, from, to);
            var low:Number = isBorder || terrain.isHole(besideColumn, besideRow) ? lowest : terrain.isBlocky ? terrain.getHeight(besideColumn, besideRow) : Infinity;
            if (low < Math.max(from[2], to[2]))
            {
                addEdge(edges, from, [from[0], from[1], low]);
                addEdge(edges, to, [to[0], to[1], low]);
                addEdge(edges, [from[0], from[1], low], [to[0], to[1], low]);
                addEdge(edges, [from[0], from[1], low], to);
            }
        }

        private static function addEdge(edges:Object, from:Array, to:Array):void
        {
            if (from.join() != to.join())
            {
                edges[keyOf(from.concat(to))] = edges[keyOf(to.concat(from))] = true;
            }
        }

        // A corner of a cell of slopes or of the top of a column.
        private static function cornerOf(terrain:Terrain, column:int, row:int, x:int, y:int):Array
        {
            var half:Number = terrain.isBlocky ? 0.5 : 0;
            return [terrain.x + (column + x - half) * terrain.cellWidth, terrain.y + (row + y - half) * terrain.cellWidth,
                    terrain.isBlocky ? terrain.getHeight(column, row) : terrain.getHeight(column + x, row + y)];
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
            assertEquals("but a column", 5 * 6, Wireframes.ofTerrain(terrain, 11, 21, 11, 21).length);
            assertEquals("9,10.5,20.5,0", Wireframes.ofTerrain(terrain, 11, 21, 11, 21, new <Number>[9]).slice(0, 4).join());
            assertThrows(ArgumentError, /terrain must/, Wireframes.ofTerrain, null, 0, 0, 1, 1);
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
