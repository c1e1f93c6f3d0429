package starlogo.ground
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import support.Complaints;

    /** Bounds of heights, beside loops over all heights and the heights of random points, while the ground changes and frames hold it. */
    public class HeightPyramidTest
    {
        private static const GRIDS:int = 25;
        private static const CHANGES:int = 16;
        private static const RECTANGLES:int = 4;
        private static const POINTS:int = 6;

        private var _random:SeededRandom = new SeededRandom(7206);
        private var _wrong:Complaints = new Complaints();
        private var _bounds:HeightBounds = new HeightBounds();
        private var _seen:Object = {copies: 0, holes: 0, steep: 0, levels: 0, narrower: 0};

        [Test]
        public function boundsAreThoseOfTheHeightsAsTheyAreNow():void
        {
            for (var i:int = 0; i < GRIDS; i++)
            {
                var grid:HeightGrid = new HeightGrid(_random.integer(2, 90), _random.integer(2, 90), _random.between(0.2, 2), _random.between(-30, 0), _random.between(-30, 0));
                _seen.levels += grid.pyramid.lastLevel > 1 ? 1 : 0;
                for (var k:int = 0; k < CHANGES; k++)
                {
                    grid = changed(grid);
                    compareWhole(grid, "grid " + i + ", change " + k);
                    for (var r:int = 0; r < RECTANGLES; r++)
                    {
                        compareAround(grid, "grid " + i + ", change " + k);
                    }
                }
            }
            _wrong.assertNone();
            for (var name:String in _seen)
            {
                assertTrue(name + ": " + _seen[name], _seen[name] > 5);
            }
        }

        // Changes a grid, or a copy of it if a frame holds it. The one that is held must stay as it is.
        private function changed(grid:HeightGrid):HeightGrid
        {
            var isHeld:Boolean = _random.chance();
            if (isHeld)
            {
                grid.hold();
            }
            var next:HeightGrid = grid.writable();
            var column:int = _random.integer(0, next.columns - 1);
            var row:int = _random.integer(0, next.rows - 1);
            if (_random.chance(0.3))
            {
                // no height changes
                next.isBlocky = !next.isBlocky;
            }
            else if (_random.chance(0.3))
            {
                next.setHole(column, row, _random.chance(0.7));
            }
            else if (_random.chance(0.1))
            {
                next.reset();
            }
            else
            {
                setSome(next, column, row);
            }
            if (isHeld)
            {
                _seen.copies++;
                compareWhole(grid, "held");
                grid.release();
            }
            return next;
        }

        private function setSome(grid:HeightGrid, column:int, row:int):void
        {
            var columns:int = _random.integer(1, grid.columns - column);
            var rows:int = _random.integer(1, grid.rows - row);
            var heights:Vector.<Number> = new Vector.<Number>();
            var scale:Number = _random.logBetween(0.01, 10);
            for (var i:int = 0; i < columns * rows; i++)
            {
                heights.push(_random.between(-scale, scale));
            }
            grid.setHeights(column, row, columns, rows, heights);
        }

        // The bounds of all heights are exact.
        private function compareWhole(grid:HeightGrid, name:String):void
        {
            var loop:HeightBounds = new HeightBounds();
            for (var i:int = 0; i < grid.heights.length; i++)
            {
                var height:Number = grid.heights[i];
                loop.min = Math.min(loop.min, height);
                loop.max = Math.max(loop.max, height);
                loop.maxStepX = i % grid.columns == 0 ? loop.maxStepX : Math.max(loop.maxStepX, Math.abs(height - grid.heights[i - 1]));
                loop.maxStepY = i < grid.columns ? loop.maxStepY : Math.max(loop.maxStepY, Math.abs(height - grid.heights[i - grid.columns]));
                loop.hasHole ||= grid.isHole(i);
            }
            _seen.holes += loop.hasHole ? 1 : 0;
            _wrong.addIf(textOf(loop) != textOf(grid.pyramid.whole), "whole", name + ": " + textOf(grid.pyramid.whole) + ", not " + textOf(loop));
        }

        // The bounds around a place contain the heights of the points there, and how steep the ground is between them along x and y.
        private function compareAround(grid:HeightGrid, name:String):void
        {
            var halfX:Number = _random.logBetween(0.01, 60);
            var halfY:Number = _random.logBetween(0.01, 60);
            var x:Number = grid.x + _random.between(0, grid.columns - 1) * grid.cellWidth;
            var y:Number = grid.y + _random.between(0, grid.rows - 1) * grid.cellWidth;
            grid.pyramid.findAround(x, y, halfX, halfY, _bounds);
            _seen.narrower += _bounds.min > grid.pyramid.whole.min && _bounds.max < grid.pyramid.whole.max ? 1 : 0;
            for (var i:int = 0; i < POINTS; i++)
            {
                var atX:Number = within(x, halfX, grid.x, grid.columns, grid.cellWidth);
                var atY:Number = within(y, halfY, grid.y, grid.rows, grid.cellWidth);
                var height:Number = grid.heightAt(atX, atY);
                var alongX:Number = grid.heightAt(within(x, halfX, grid.x, grid.columns, grid.cellWidth), atY);
                var slack:Number = 1e-9 * (1 + Math.abs(_bounds.min) + Math.abs(_bounds.max));
                _wrong.addIf(isNaN(height) && !_bounds.hasHole, "hole", name);
                _wrong.addIf(height < _bounds.min - slack || height > _bounds.max + slack, "height", name + ": " + height + ", " + textOf(_bounds));
                _wrong.addIf(Math.abs(alongX - height) > _bounds.max - _bounds.min + slack, "difference", name);
                compareSlope(grid, x, halfX, atX, atY, name);
            }
        }

        // Two points of slopes that are near along x differ by no more than their share of a cell's rise.
        private function compareSlope(grid:HeightGrid, x:Number, halfX:Number, atX:Number, atY:Number, name:String):void
        {
            var next:Number = Math.min(atX + 0.01 * grid.cellWidth, x + halfX, grid.x + (grid.columns - 1) * grid.cellWidth);
            var rise:Number = Math.abs(grid.heightAt(next, atY) - grid.heightAt(atX, atY));
            if (!grid.isBlocky && rise > 0)
            {
                _seen.steep++;
                _wrong.addIf(rise > _bounds.maxStepX * (next - atX) / grid.cellWidth + 1e-9 * (1 + _bounds.maxStepX), "rise", name + ": " + rise + ", " + textOf(_bounds));
            }
        }

        // A random coordinate in a rectangle, and on the ground.
        private function within(middle:Number, half:Number, start:Number, count:int, width:Number):Number
        {
            return Math.max(start, Math.min(start + (count - 1) * width, middle + _random.between(-half, half)));
        }

        private static function textOf(bounds:HeightBounds):String
        {
            return [bounds.min, bounds.max, bounds.maxStepX, bounds.maxStepY, bounds.hasHole].join(" ");
        }
    }
}
