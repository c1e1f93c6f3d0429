package starlogo.models
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.data.areFinite;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;

    use namespace engine;

    /**
     * A model's place and scale in its source. A renderer needs it to draw the source exactly where the model is. The source's
     * coordinates are the coordinates given to <code>Model</code>'s constructor, with z up. For a file with another up axis they are the
     * coordinates after the turn to z up, and before a ModelTransform.
     */
    public final class SourceFrame
    {
        // A point p of the source is at matrix * (p - offset) in the model. The matrix has no translation.
        private var _matrix:AffineTransform = new AffineTransform();
        private var _offset:Vector.<Number> = new <Number>[0, 0, 0];

        // How many units of the source are one of the model.
        private var _sourceUnits:Number = 1;

        /** The frame of a model that equals its source. Read a model's frame from <code>Model.source</code> instead. */
        public function SourceFrame()
        {
        }

        /** The source's point that becomes the model's origin. */
        public function get offset():Vector3D
        {
            return new Vector3D(_offset[0], _offset[1], _offset[2]);
        }

        /** The length of the model's unit, in units of the source. For a non-uniform scale it is the geometric mean. */
        public function get unit():Number
        {
            return _sourceUnits;
        }

        /** The matrix that takes the source's points to the model. */
        public function get matrix():Matrix3D
        {
            var rows:Vector.<Number> = _matrix.rows;
            var columns:Vector.<Number> = new Vector.<Number>();
            for (var column:int = 0; column < 3; column++)
            {
                columns.push(rows[column], rows[column + 4], rows[column + 8], 0);
            }
            for (var row:int = 0; row < 12; row += 4)
            {
                columns.push(-rows[row] * _offset[0] - rows[row + 1] * _offset[1] - rows[row + 2] * _offset[2]);
            }
            columns.push(1);
            return new Matrix3D(columns);
        }

        /**
         * Takes points of the model back to the source. The result is exact but for rounding.
         *
         * @private
         */
        engine function toSource(points:Vector.<Number>):Vector.<Number>
        {
            var back:Vector.<Number> = new Vector.<Number>();
            for (var k:int = 0; k < 3; k++)
            {
                for (var row:int = 0; row < 3; row++)
                {
                    back.push(inverseAt(row, k));
                }
                back.push(_offset[k]);
            }
            var all:Vector.<Number> = new Vector.<Number>(points.length);
            new AffineTransform(back).transformPoints(points, 0, points.length / 3, all, 0);
            return all;
        }

        /**
         * Takes points of the source to the model.
         *
         * @param points x, y, z of each
         * @param out receives the points; as long as the points
         *
         * @private
         */
        engine function toModel(points:Vector.<Number>, out:Vector.<Number>):void
        {
            var x:Number = _offset[0];
            var y:Number = _offset[1];
            var z:Number = _offset[2];
            for (var i:int = 0; i < points.length; i += 3)
            {
                out[i] = points[i] - x;
                out[int(i + 1)] = points[int(i + 1)] - y;
                out[int(i + 2)] = points[int(i + 2)] - z;
            }
            _matrix.transformPoints(out, 0, points.length / 3, out, 0);
        }

        /** @private Its numbers: the matrix row by row, the offset and the unit. */
        engine function toNumbers():Vector.<Number>
        {
            var m:Vector.<Number> = _matrix.rows;
            return new <Number>[m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], _offset[0], _offset[1], _offset[2], _sourceUnits];
        }

        /** @private The frame with these numbers. */
        engine static function ofNumbers(n:Vector.<Number>):SourceFrame
        {
            var frame:SourceFrame = new SourceFrame();
            frame._matrix = new AffineTransform(new <Number>[n[0], n[1], n[2], 0, n[3], n[4], n[5], 0, n[6], n[7], n[8], 0]);
            frame._offset = n.slice(9, 12);
            frame._sourceUnits = n[12];
            return frame;
        }

        /** @private Whether all numbers are finite, and the unit is positive. */
        engine function get isValid():Boolean
        {
            return areFinite(toNumbers()) && _sourceUnits > 0;
        }

        /**
         * Adds a translation and a scale: the point (x, y, z) of the model so far becomes the origin, and all lengths are divided by
         * divisor.
         *
         * @private
         */
        engine function addMoveAndScale(x:Number, y:Number, z:Number, divisor:Number):void
        {
            for (var k:int = 0; k < 3; k++)
            {
                _offset[k] += x * inverseAt(0, k) + y * inverseAt(1, k) + z * inverseAt(2, k);
            }
            _matrix.divideBy(divisor);
            _sourceUnits *= divisor;
        }

        /**
         * Adds a turn about the origin, or factors along the axes. A turn comes before any non-uniform scale.
         *
         * @param by turns or scales the model
         * @param factor how much larger that makes the model
         *
         * @private
         */
        engine function addTransform(by:AffineTransform, factor:Number):void
        {
            _matrix = by.after(_matrix);
            _sourceUnits /= factor;
        }

        // How far one unit along an axis of the model, which is a row of the matrix, goes along an axis of the source. A turn's inverse is its
        // transpose, and the factors along the new axes are divided out. The row's largest number is divided out before its numbers are squared,
        // because the squares of very small or large numbers are 0 or infinite.
        private function inverseAt(row:int, axis:int):Number
        {
            var first:int = 4 * row;
            var x:Number = _matrix.rows[first];
            var y:Number = _matrix.rows[first + 1];
            var z:Number = _matrix.rows[first + 2];
            var largest:Number = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
            x /= largest;
            y /= largest;
            z /= largest;
            return _matrix.rows[first + axis] / largest / (x * x + y * y + z * z) / largest;
        }
    }
}
