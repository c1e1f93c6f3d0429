package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.terrain.Terrain;

    /** Draws the surface of a terrain between the heights that are in a rectangle. */
    internal final class TerrainPen
    {
        private var _terrain:Terrain;
        private var _pen:LinePen;
        private var _first:int;
        private var _last:int;
        private var _firstRow:int;
        private var _lastRow:int;

        /** The parameters are those of Wireframes.ofTerrain. */
        public function TerrainPen(terrain:Terrain, minX:Number, minY:Number, maxX:Number, maxY:Number, pen:LinePen)
        {
            _terrain = terrain;
            _pen = pen;
            _first = within(Math.ceil((minX - terrain.x) / terrain.cellWidth), 0, terrain.columns);
            _firstRow = within(Math.ceil((minY - terrain.y) / terrain.cellWidth), 0, terrain.rows);
            _last = within(Math.floor((maxX - terrain.x) / terrain.cellWidth), -1, terrain.columns - 1);
            _lastRow = within(Math.floor((maxY - terrain.y) / terrain.cellWidth), -1, terrain.rows - 1);
        }

        /** Draws each line once. */
        public function draw():void
        {
            // columns have corners beyond the last height
            for (var row:int = _firstRow; row <= _lastRow + 1; row++)
            {
                for (var column:int = _first; column <= _last + 1; column++)
                {
                    if (_terrain.isBlocky)
                    {
                        drawColumns(column, row);
                    }
                    else
                    {
                        drawSlope(column, row, 1, 0);
                        drawSlope(column, row, 0, 1);
                        drawSlope(column, row, 1, 1);
                    }
                }
            }
        }

        private static function within(value:Number, least:int, greatest:int):int
        {
            return Math.max(least, Math.min(greatest, value));
        }

        // Draws the line from a height to a neighbour.
        private function drawSlope(column:int, row:int, columns:int, rows:int):void
        {
            drawLine(column, row, heightOf(column, row), column + columns, row + rows, heightOf(column + columns, row + rows));
        }

        // Draws the lines of the corner that four columns have in common. These are the edges of their tops that lead from there along x
        // and y, and an upright line.
        private function drawColumns(column:int, row:int):void
        {
            var here:Number = heightOf(column, row);
            var before:Number = heightOf(column - 1, row);
            var below:Number = heightOf(column, row - 1);
            var beforeBelow:Number = heightOf(column - 1, row - 1);
            drawTops(column, row, 1, 0, here, below);
            drawTops(column, row, 0, 1, here, before);
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for each (var height:Number in [here, before, below, beforeBelow])
            {
                low = height < low ? height : low;
                high = height > high ? height : high;
            }
            if (high > low)
            {
                drawLine(column - 0.5, row - 0.5, low, column - 0.5, row - 0.5, high);
            }
        }

        // Draws the edge between two columns. It is one line if they have the same height.
        private function drawTops(column:int, row:int, columns:int, rows:int, a:Number, b:Number):void
        {
            drawLine(column - 0.5, row - 0.5, a, column - 0.5 + columns, row - 0.5 + rows, a);
            if (a != b)
            {
                drawLine(column - 0.5, row - 0.5, b, column - 0.5 + columns, row - 0.5 + rows, b);
            }
        }

        private function drawLine(column:Number, row:Number, height:Number, toColumn:Number, toRow:Number, toHeight:Number):void
        {
            if (!isNaN(height + toHeight))
            {
                _pen.drawLine(placeOf(column, row, height), placeOf(toColumn, toRow, toHeight));
            }
        }

        private function placeOf(column:Number, row:Number, height:Number):Vector3D
        {
            return new Vector3D(_terrain.x + column * _terrain.cellWidth, _terrain.y + row * _terrain.cellWidth, height);
        }

        // The height at a column and a row. It is NaN outside of the rectangle.
        private function heightOf(column:int, row:int):Number
        {
            return column >= _first && column <= _last && row >= _firstRow && row <= _lastRow ? _terrain.getHeight(column, row) : NaN;
        }
    }
}
