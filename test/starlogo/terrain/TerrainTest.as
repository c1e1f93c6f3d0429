package starlogo.terrain
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;
    import starlogo.ground.HeightPyramid;
    import starlogo.ground.HeightBounds;
    import support.RandomGround;
    import support.assertThrows;
    import support.assign;
    import support.create;

    use namespace engine;

    /** Heights, both surfaces, mounds and walls, and what is refused. */
    public class TerrainTest
    {
        private var _terrain:Terrain = new Terrain(3, 3, 2, -2, -2);

        [Before]
        public function makeTerrain():void
        {
            // 0 1 2 along x, 10 more each row
            _terrain.setHeights(0, 0, 3, 3, new <Number>[0, 1, 2, 10, 11, 12, 20, 21, 22]);
        }

        [Test]
        public function heightsAreWhereTheyWereSet():void
        {
            for (var row:int = 0; row < 3; row++)
            {
                for (var column:int = 0; column < 3; column++)
                {
                    assertEquals(column + 10 * row, _terrain.heightAt(2 * column - 2, 2 * row - 2));
                    assertEquals(column + 10 * row, _terrain.getHeight(column, row));
                }
            }
            var part:Terrain = new Terrain(3, 3);
            part.setHeights(1, 1, 2, 2, new <Number>[1, 2, 3, 4]);
            assertEquals("row by row", "1,2,3,4,0", [part.getHeight(1, 1), part.getHeight(2, 1), part.getHeight(1, 2), part.getHeight(2, 2), part.getHeight(0, 1)].join());
        }

        [Test]
        public function slopesAreCutFromTheLeastCornerToTheGreatest():void
        {
            var terrain:Terrain = new Terrain(2, 2);
            terrain.setHeight(1, 0, 1);
            assertEquals(0, terrain.heightAt(0.5, 0.5));
            assertEquals(0.5, terrain.heightAt(0.75, 0.25));
            assertEquals(0, terrain.heightAt(0.25, 0.75));
            terrain.setHeight(1, 0, 0);
            terrain.setHeight(0, 1, 1);
            assertEquals(0, terrain.heightAt(0.5, 0.5));
            assertEquals(0.5, terrain.heightAt(0.25, 0.75));
            terrain.setHeight(0, 1, 0);
            terrain.setHeight(1, 1, 1);
            assertEquals(0.5, terrain.heightAt(0.5, 0.5));
        }

        [Test]
        public function columnsAreAroundTheirHeights():void
        {
            _terrain.isBlocky = true;
            assertEquals(11, _terrain.heightAt(0.9, -0.9));
            assertEquals(0, _terrain.heightAt(-2.9, -2.9));
            assertEquals(22, _terrain.heightAt(3, 3));
            assertEquals("the higher one at a border", 12, _terrain.heightAt(1, 0));
            assertEquals("the highest of four", 22, _terrain.heightAt(1, 1));
            assertTrue(isNaN(_terrain.heightAt(3.1, 0)));
            _terrain.setHeight(1, 0, 30);
            assertEquals("to the left as well", 30, _terrain.heightAt(1, -2));
        }

        [Test]
        public function theLastHeightIsWithinTheTerrain():void
        {
            for each (var start:Number in [0.1, -7.3, 1 / 3, 1000.7])
            {
                for each (var width:Number in [0.1, 0.3, 0.7, 1 / 3])
                {
                    for (var columns:int = 2; columns < 40; columns++)
                    {
                        var terrain:Terrain = new Terrain(columns, 2, width, start, start);
                        terrain.setHeight(columns - 1, 1, 5);
                        var x:Number = start + (columns - 1) * width;
                        var y:Number = start + width;
                        assertTrue([start, width, columns].join(), Math.abs(terrain.heightAt(x, y) - 5) < 1e-9);
                        assertTrue(terrain.normalAt(x, y) != null);
                        terrain.isBlocky = true;
                        assertEquals([start, width, columns, "columns"].join(), 5, terrain.heightAt(x + width / 2, y + width / 2));
                        terrain.raiseWall(x + width / 2, y + width / 2, 1);
                        assertEquals(6, terrain.getHeight(columns - 1, 1));
                    }
                }
            }
        }

        [Test]
        public function normalsAreThoseOfTheTriangles():void
        {
            var random:SeededRandom = new SeededRandom(5);
            for (var i:int = 0; i < 200; i++)
            {
                var terrain:Terrain = RandomGround.make("rough", random);
                terrain.isBlocky = false;
                var x:Number = terrain.x + random.between(0, (terrain.columns - 1) * terrain.cellWidth);
                var y:Number = terrain.y + random.between(0, (terrain.rows - 1) * terrain.cellWidth);
                var step:Number = 1e-7;
                var normal:Vector3D = terrain.normalAt(x, y);
                var alongX:Number = (terrain.heightAt(x + step, y) - terrain.heightAt(x, y)) / step;
                var alongY:Number = (terrain.heightAt(x, y + step) - terrain.heightAt(x, y)) / step;
                if (!isNaN(alongX + alongY))
                {
                    assertTrue("of length 1, and up", Math.abs(normal.length - 1) < 1e-12 && normal.z > 0);
                    assertTrue("across x", Math.abs(normal.x + alongX * normal.z) < 1e-5);
                    assertTrue("across y", Math.abs(normal.y + alongY * normal.z) < 1e-5);
                }
            }
        }

        [Test]
        public function aHoleIsLikeTheOutside():void
        {
            _terrain.setHole(1, 1, true);
            assertTrue(_terrain.isHole(1, 1));
            assertFalse(_terrain.isHole(0, 1));
            assertEquals("a hole keeps its height", 11, _terrain.getHeight(1, 1));
            assertTrue(isNaN(_terrain.heightAt(0.5, 0.7)));
            assertEquals(null, _terrain.normalAt(0.5, 0.7));
            assertEquals("the border belongs to the ground beside it", 11, _terrain.heightAt(0, 0));
            assertEquals(11.5, _terrain.heightAt(1, 0));
            assertEquals(16, _terrain.heightAt(0, 1));
            assertTrue("but not where the grid ends", isNaN(_terrain.heightAt(2, 1)) && isNaN(_terrain.heightAt(2, 2)));
            var agent:Agent = new Agent("cube");
            agent.moveTo(0.5, 0.7, -100);
            assertFalse(_terrain.isUnder(agent));
            agent.moveTo(-0.5, 0.7, -100);
            assertTrue(_terrain.isUnder(agent));
            _terrain.setHole(0, 1, true);
            _terrain.setHole(1, 0, true);
            assertEquals("diagonally", 11, _terrain.heightAt(0, 0));
            assertTrue(isNaN(_terrain.heightAt(0, 1)));
            _terrain.isBlocky = true;
            assertTrue("one column", isNaN(_terrain.heightAt(0, 0)));
            assertEquals("higher holes do not count", 0, _terrain.heightAt(-1, -1));
            assertEquals(21, _terrain.heightAt(-1, 1));
            checkBounds(_terrain);
            _terrain.setHole(1, 1, false);
            assertEquals(11, _terrain.heightAt(0.5, 0.7));
            _terrain.reset();
            assertFalse(_terrain.isHole(0, 1));
            assertEquals(0, _terrain.heightAt(0, -2));
            assertThrows(RangeError, "column 3 and row 0", _terrain.setHole, 3, 0, true);
            assertThrows(RangeError, "column 0 and row -1", _terrain.isHole, 0, -1);
        }

        // With slopes the last height along x or y has no cell of its own.
        [Test]
        public function aHoleOfTheLastColumnOrRowIsSeenOnlyOfBlocks():void
        {
            for each (var at:Array in [[2, 1], [1, 2], [2, 2]])
            {
                var terrain:Terrain = new Terrain(3, 3, 2, -2, -2);
                terrain.setHole(at[0], at[1], true);
                assertTrue(at + " is noted", terrain.isHole(at[0], at[1]));
                for (var i:int = 0; i < 81; i++)
                {
                    assertEquals(at + ", slopes", 0, terrain.heightAt(i % 9 / 2 - 2, int(i / 9) / 2 - 2));
                }
                terrain.isBlocky = true;
                assertTrue(at + ", blocks", isNaN(terrain.heightAt(2 * at[0] - 2, 2 * at[1] - 2)));
                terrain.isBlocky = false;
                assertEquals(at + ", slopes again", 0, terrain.heightAt(2 * at[0] - 2, 2 * at[1] - 2));
            }
        }

        [Test]
        public function theBorderOfAHoleBelongsToTheGroundAlsoIfItIsRounded():void
        {
            var terrain:Terrain = new Terrain(60, 60, 0.1);
            terrain.setHeight(4, 3, 2);
            for each (terrain.isBlocky in [false, true])
            {
                var before:Number = terrain.isBlocky ? 0.05 : 0;
                for (var i:int = 3; i < 57; i++)
                {
                    terrain.setHole(i, 3, true);
                    assertFalse("before " + i, isNaN(terrain.heightAt(-before + i * 0.1, 0.35 - before)));
                    assertFalse("after " + i, isNaN(terrain.heightAt(-before + (i + 1) * 0.1, 0.35 - before)));
                    terrain.setHole(i, 3, false);
                }
            }
        }

        [Test]
        public function aHoleIsMadeAtAPlace():void
        {
            var random:SeededRandom = new SeededRandom(74);
            for each (var isBlocky:Boolean in [false, true])
            {
                for (var n:int = 0; n < 200; n++)
                {
                    var terrain:Terrain = new Terrain(random.integer(2, 6), random.integer(2, 6), random.between(0.1, 3), random.between(-9, 9), random.between(-9, 9));
                    terrain.isBlocky = isBlocky;
                    var border:Number = isBlocky ? terrain.cellWidth / 2 : 0;
                    var x:Number = random.between(terrain.x - border, terrain.x + (terrain.columns - 1) * terrain.cellWidth + border);
                    var y:Number = random.between(terrain.y - border, terrain.y + (terrain.rows - 1) * terrain.cellWidth + border);
                    terrain.setHoleAt(x, y, true);
                    assertTrue("at (" + x + ", " + y + ")", isNaN(terrain.heightAt(x, y)));
                    assertEquals("one", 1, countHoles(terrain));
                    terrain.setHoleAt(x, y, false);
                    assertEquals("filled", 0, countHoles(terrain));
                }
            }
            _terrain.setHoleAt(2, 2, true);
            assertTrue("the last place of slopes is in the last cell", _terrain.isHole(1, 1));
            assertThrows(RangeError, "a hole at (2.5, 0) is outside", _terrain.setHoleAt, 2.5, 0, true);
            _terrain.isBlocky = true;
            _terrain.setHoleAt(2.5, 0, true);
            assertTrue("a column begins before its height and ends after it", _terrain.isHole(2, 1));
            assertThrows(RangeError, "a hole at (0, -3.5) is outside", _terrain.setHoleAt, 0, -3.5, true);
            assertThrows(RangeError, "a hole's place", _terrain.setHoleAt, NaN, 0, true);
        }

        [Test]
        public function boundsKnowTheHoles():void
        {
            var random:SeededRandom = new SeededRandom(733);
            var terrain:Terrain = new Terrain(100, 70);
            for (var i:int = 0; i < 60; i++)
            {
                terrain.setHole(random.integer(0, 99), random.integer(0, 69), random.chance(0.7));
                if (i % 6 == 0)
                {
                    checkBounds(terrain);
                }
            }
        }

        [Test]
        public function moundsAreRoundAndAddToWhatIsThere():void
        {
            var terrain:Terrain = new Terrain(11, 11);
            terrain.setHeight(5, 5, 1);
            terrain.raiseMound(5, 5, 8, 2);
            assertEquals(3, terrain.getHeight(5, 5));
            assertEquals(0, terrain.getHeight(9, 5));
            assertEquals(2 * 0.75 * 0.75, terrain.getHeight(7, 5));
            assertEquals(terrain.getHeight(7, 5), terrain.getHeight(5, 3));
            assertEquals(0, terrain.getHeight(8, 8));
            terrain.raiseMound(0, 0, 4, -1);
            assertEquals("cut off at the border", -1, terrain.getHeight(0, 0));
        }

        [Test]
        public function theNarrowestMoundRaisesItsMiddle():void
        {
            for each (var width:Number in [1e-9, 1e-300, Number.MIN_VALUE])
            {
                var terrain:Terrain = new Terrain(5, 5);
                terrain.raiseMound(2, 2, width, 1);
                assertEquals(width, 1, terrain.getHeight(2, 2));
                terrain.raiseMound(2.5, 2, width, 1);
                assertEquals(width, 0, terrain.getHeight(3, 2));
            }
        }

        [Test]
        public function wallsRaiseTheNearestHeight():void
        {
            _terrain.raiseWall(0.9, 0.9, 4);
            assertEquals(15, _terrain.getHeight(1, 1));
            _terrain.raiseWall(-3, -3, 4);
            assertEquals(4, _terrain.getHeight(0, 0));
            _terrain.raiseWall(3, 3, 5);
            assertEquals(22 + 5, _terrain.getHeight(2, 2));
            _terrain.reset();
            assertEquals(0, _terrain.getHeight(1, 1));
            assertEquals(0, _terrain.heightAt(0.3, 1.2));
        }

        [Test]
        public function squaresKnowTheirBounds():void
        {
            var random:SeededRandom = new SeededRandom(6);
            for (var i:int = 0; i < 30; i++)
            {
                var columns:int = i % 10 == 0 ? random.integer(65, 600) : random.integer(2, 40);
                var terrain:Terrain = new Terrain(columns, columns > 40 ? 3 : random.integer(2, 40));
                for (var k:int = 0; k < 12; k++)
                {
                    var column:int = random.integer(0, terrain.columns - 1);
                    var row:int = random.integer(0, terrain.rows - 1);
                    if (random.chance(0.5))
                    {
                        terrain.setHeight(column, row, random.between(-9, 9));
                    }
                    else
                    {
                        terrain.raiseMound(column, row, random.between(1, 30), random.between(-9, 9));
                    }
                    checkBounds(terrain);
                    terrain.isBlocky = k % 2 == 0;
                    checkAround(terrain, random);
                }
                terrain.reset();
                checkBounds(terrain);
            }
        }

        [Test]
        public function aPictureHasItsTopInTheNorth():void
        {
            // as an ImageData: white and grey above black and red
            var picture:Object = {width: 2, height: 2, data: [255, 255, 255, 255, 51, 51, 51, 255, 0, 0, 0, 255, 255, 0, 0, 255]};
            var terrain:Terrain = Terrain.fromPicture(picture, 3, 2, -1, -1);
            assertEquals(3, terrain.heightAt(-1, 1));
            assertEquals(0.6, terrain.heightAt(1, 1));
            assertEquals(0, terrain.heightAt(-1, -1));
            assertEquals(1, terrain.heightAt(1, -1));
            checkBounds(terrain);

            // as a BitmapData
            var bitmap:Object = {width: 2, height: 2, getPixel: function(x:int, y:int):uint
                {
                    return [[0xffffff, 0x333333], [0, 0xff0000]][y][x];
                }
            };
            var same:Terrain = Terrain.fromPicture(bitmap, 3, 2, -1, -1);
            for (var corner:int = 0; corner < 4; corner++)
            {
                assertEquals(terrain.getHeight(corner & 1, corner >> 1), same.getHeight(corner & 1, corner >> 1));
            }
            for each (var noPicture:Object in [null, {}, {width:2, height:2, data:null}, {width:2, height:2}])
            {
                assertThrows(ArgumentError, /^picture must be a BitmapData or an ImageData, not /, Terrain.fromPicture, noPicture, 1);
            }
            assertThrows(ArgumentError, /too little data: 15/, Terrain.fromPicture, {width: 2, height: 2, data: picture.data.slice(1)}, 1);
            for each (var height:Number in [NaN, Infinity, -Infinity, 1.1e9])
            {
                // a black picture has no use for the height
                for each (var data:Array in [picture.data, [0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255]])
                {
                    assertThrows(RangeError, new RegExp("the height of white must be .*, not " + height), Terrain.fromPicture, {width:2, height:2, data:data}, height);
                }
            }
            for each (height in [1e9, -1e9, 0.1, 0.7, 1.1, 12.3, 1 / 3, 99.9])
            {
                assertEquals("white is exactly as high", height, Terrain.fromPicture(picture, height).getHeight(0, 1));
            }
        }

        [Test]
        public function itsAgentIsOfItsOwnBreed():void
        {
            assertEquals("*terrain", _terrain.agent.breed);
            assertThrows(ArgumentError, /./, assign, _terrain.agent, "breed", "turtles");
            assertThrows(ArgumentError, /./, create, Agent, "any", "*terrain");
            assertThrows(ArgumentError, /./, assign, new Agent("any"), "breed", "*terrain");
        }

        [Test]
        public function badGridsAreRefusedWithTheValue():void
        {
            for each (var bad:Array in [[0, 5, 1, 0, 0, "0"], [5, 1, 1, 0, 0, "1"], [-3, 5, 1, 0, 0, "-3"], [4002, 4001, 1, 0, 0, "4002"], [2, 2, 0, 0, 0, "0"],
                        [2, 2, -1, 0, 0, "-1"], [2, 2, NaN, 0, 0, "NaN"], [2, 2, 1, NaN, 0, "NaN"], [2, 2, 1, 0, Infinity, "Infinity"], [2, 2, 1e9, 1e9, 0, ""]])
            {
                assertThrows(RangeError, bad[5], create, Terrain, bad[0], bad[1], bad[2], bad[3], bad[4]);
            }
        }

        // With blocks, the ground reaches half a cell beyond its heights.
        [Test]
        public function allBlocksAreInTheWorld():void
        {
            var largest:Terrain = new Terrain(2, 2, 1e9, -5e8, -5e8);
            largest.isBlocky = true;
            assertEquals(0, largest.heightAt(1e9, -1e9));
            assertThrows(RangeError, "-1500000000", create, Terrain, 2, 2, 1e9, -1e9, -1e9);
            assertThrows(RangeError, "1000000001", create, Terrain, 2, 2, 1e9, -5e8 + 1, -5e8);
        }

        [Test]
        public function badHeightsAndRegionsAreRefusedAndNothingChanges():void
        {
            assertThrows(RangeError, "NaN", _terrain.setHeight, 0, 0, NaN);
            assertThrows(RangeError, "Infinity", _terrain.setHeight, 0, 0, Infinity);
            assertThrows(RangeError, "2000000000", _terrain.setHeight, 0, 0, 2e9);
            var small:Terrain = new Terrain(4, 3, 0.5, -5, 7);
            var noPlace:RegExp = /^there is no height at column -3 and row 0 of the terrain of 4 by 3 heights, .*from \(-5, 7\); .* count heights, from 0 on: they are no places$/;
            assertThrows(RangeError, noPlace, small.setHeight, -3, 0, 1);
            assertThrows(RangeError, noPlace, small.setHole, -3, 0, true);
            assertThrows(RangeError, "column 3 and row 0", _terrain.setHeight, 3, 0, 1);
            assertThrows(RangeError, "column 0 and row -1", _terrain.setHeight, 0, -1, 1);
            assertThrows(RangeError, "column 0 and row 3", _terrain.getHeight, 0, 3);
            assertThrows(RangeError, "3 by 1", _terrain.setHeights, 1, 1, 3, 1, new <Number>[1, 2, 3]);
            assertThrows(RangeError, "0 by 1", _terrain.setHeights, 0, 0, 0, 1, new <Number>[]);
            assertThrows(RangeError, "3", _terrain.setHeights, 0, 0, 2, 2, new <Number>[1, 2, 3]);
            assertThrows(RangeError, "NaN", _terrain.setHeights, 0, 0, 2, 1, new <Number>[1, NaN]);
            assertThrows(RangeError, "0", _terrain.raiseMound, 0, 0, 0, 1);
            assertThrows(RangeError, "NaN", _terrain.raiseMound, 0, 0, NaN, 1);
            assertThrows(RangeError, "Infinity", _terrain.raiseMound, 0, 0, 4, Infinity);
            assertThrows(RangeError, "NaN", _terrain.raiseMound, NaN, 0, 4, 1);
            assertThrows(RangeError, "(9, 0)", _terrain.raiseMound, 9, 0, 4, 1);
            assertThrows(RangeError, "1000000011", _terrain.raiseMound, 0, 0, 4, 1e9);
            assertThrows(RangeError, "(-0.9, -0.9)", new Terrain(5, 5).raiseMound, -0.9, -0.9, 1, 3);
            assertThrows(RangeError, "(5, 0)", _terrain.raiseWall, 5, 0, 1);
            assertThrows(RangeError, "NaN", _terrain.raiseWall, 0, NaN, 1);
            assertThrows(RangeError, "NaN", _terrain.raiseWall, 0, 0, NaN);
            assertThrows(ArgumentError, /./, _terrain.setHeights, 0, 0, 1, 1, null);
            assertThrows(ArgumentError, /./, _terrain.isUnder, null);
            heightsAreWhereTheyWereSet();
            checkBounds(_terrain);
        }

        private static function countHoles(terrain:Terrain):int
        {
            var count:int = 0;
            for (var at:int = 0; at < terrain.columns * terrain.rows; at++)
            {
                count += terrain.isHole(at % terrain.columns, at / terrain.columns) ? 1 : 0;
            }
            return count;
        }

        // The bounds of every square are those of its heights and of the heights around them.
        private function checkBounds(terrain:Terrain):void
        {
            var grid:HeightGrid = terrain.grid;
            var levels:int = grid.pyramid.lastLevel;
            for (var level:int = 1; level <= levels; level++)
            {
                var size:int = 1 << level * HeightPyramid.SHIFT;
                for (var row:int = 0; row * size < terrain.rows; row++)
                {
                    for (var column:int = 0; column * size < terrain.columns; column++)
                    {
                        var range:HeightBounds = new HeightBounds();
                        grid.pyramid.findRange(level, column, row, column, row, range);
                        checkSquare(terrain, column * size, row * size, size, range);
                    }
                }
            }
            assertTrue("the last level is one square", terrain.columns <= 1 << levels * HeightPyramid.SHIFT && terrain.rows <= 1 << levels * HeightPyramid.SHIFT);
        }

        // The ground within a reach of a place is between the bounds that are found there.
        private static function checkAround(terrain:Terrain, random:SeededRandom):void
        {
            var range:HeightBounds = new HeightBounds();
            var x:Number = random.between(0, terrain.columns - 1);
            var y:Number = random.between(0, terrain.rows - 1);
            var reachX:Number = random.between(0, 9);
            var reachY:Number = random.between(0, 9);
            terrain.grid.pyramid.findAround(x, y, reachX, reachY, range);
            for (var i:int = 0; i < 30; i++)
            {
                var height:Number = terrain.heightAt(x + random.pick([-1, 1, random.between(-1, 1)]) * reachX, y + random.pick([-1, 1, random.between(-1, 1)]) * reachY);
                assertFalse(height + " is out of bounds", height < range.min || height > range.max);
            }
        }

        private function checkSquare(terrain:Terrain, first:int, firstRow:int, size:int, bounds:HeightBounds):void
        {
            var least:Number = Infinity;
            var greatest:Number = -Infinity;
            var maxStepX:Number = 0;
            var maxStepY:Number = 0;
            var hasHole:Boolean = false;
            var end:int = Math.min(terrain.columns, first + size + 1);
            var endRow:int = Math.min(terrain.rows, firstRow + size + 1);
            first = Math.max(0, first - 1);
            firstRow = Math.max(0, firstRow - 1);
            for (var row:int = firstRow; row < endRow; row++)
            {
                for (var column:int = first; column < end; column++)
                {
                    var height:Number = terrain.getHeight(column, row);
                    hasHole ||= terrain.isHole(column, row);
                    least = Math.min(least, height);
                    greatest = Math.max(greatest, height);
                    maxStepX = Math.max(maxStepX, column == first ? 0 : Math.abs(height - terrain.getHeight(column - 1, row)));
                    maxStepY = Math.max(maxStepY, row == firstRow ? 0 : Math.abs(height - terrain.getHeight(column, row - 1)));
                }
            }
            assertEquals(least, bounds.min);
            assertEquals(greatest, bounds.max);
            assertEquals(maxStepX, bounds.maxStepX);
            assertEquals(maxStepY, bounds.maxStepY);
            assertEquals(hasHole, bounds.hasHole);
        }
    }
}
