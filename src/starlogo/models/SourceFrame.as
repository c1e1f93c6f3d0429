package starlogo.models
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.VertexData;
    import starlogo.geometry.cubeRoot;

    use namespace engine;

    /**
     * Where a model is in what it was made of, and how large: what another renderer's object needs that draws the source as it is. The
     * source's coordinates are those that <code>Model</code>'s constructor takes, z up; of a file that has another axis up, those after it was
     * turned, and before a ModelTransform.
     */
    public final class SourceFrame
    {
        /**
         * How the model was scaled.
         *
         * @private
         */
        engine var scaling:String = null;

        /**
         * What turned, scaled and moved it.
         *
         * @private
         */
        engine var transform:ModelTransform = null;

        // Nine row by row, x, y and z: a point p of the source is at rows * (p - (x, y, z)) in the model. And the unit.
        private var _numbers:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];

        /** The frame of a model that is its source, unchanged. Frames come from <code>Model.source</code>. */
        public function SourceFrame()
        {
        }

        /** The point of the source that is the model's origin. */
        public function get offset():Vector3D
        {
            return new Vector3D(_numbers[9], _numbers[10], _numbers[11]);
        }

        /** The length of the model's unit, in units of the source; of an uneven scale its geometric mean. */
        public function get unit():Number
        {
            return _numbers[12];
        }

        /** The matrix that takes points of the source to where the model has them. */
        public function get matrix():Matrix3D
        {
            var rows:Vector.<Number> = _numbers;
            var columns:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 3; i++)
            {
                columns.push(rows[i], rows[i + 3], rows[i + 6], 0);
            }
            for (i = 0; i < 9; i += 3)
            {
                columns.push(-rows[i] * rows[9] - rows[i + 1] * rows[10] - rows[i + 2] * rows[11]);
            }
            columns.push(1);
            return new Matrix3D(columns);
        }

        /**
         * The points of the source that points of the model are, but for rounding.
         *
         * @private
         */
        engine function pointsOf(points:Vector.<Number>):Vector.<Number>
        {
            var all:Vector.<Number> = new Vector.<Number>();
            var rows:Vector.<Number> = _numbers;
            var inverse:Vector.<Number> = new Vector.<Number>(9);
            for (var i:int = 0; i < 9; i++)
            {
                var row:int = i - i % 3;
                inverse[i] = rows[i] / (rows[row] * rows[row] + rows[row + 1] * rows[row + 1] + rows[row + 2] * rows[row + 2]);
            }
            for (i = 0; i < points.length; i += 3)
            {
                var x:Number = points[i];
                var y:Number = points[i + 1];
                var z:Number = points[i + 2];
                for (var k:int = 0; k < 3; k++)
                {
                    all.push(rows[9 + k] + inverse[k] * x + inverse[k + 3] * y + inverse[k + 6] * z);
                }
            }
            return all;
        }

        /**
         * Whether another is the same to the last bit.
         *
         * @private
         */
        engine function isAs(other:SourceFrame):Boolean
        {
            return VertexData.areSame(_numbers, other._numbers);
        }

        /**
         * Writes where and how large the model is.
         *
         * @private
         */
        engine function writeTo(bytes:ByteArray):void
        {
            for each (var number:Number in _numbers)
            {
                bytes.writeDouble(number);
            }
        }

        /**
         * Reads what writeTo wrote.
         *
         * @param bytes read from its position on
         * @param scaling how the model was scaled
         * @return null if a number is not finite, or the unit is not positive
         *
         * @private
         */
        engine static function read(bytes:ByteArray, scaling:String):SourceFrame
        {
            var frame:SourceFrame = new SourceFrame();
            var sum:Number = 0;
            for (var i:int = 0; i < 13; i++)
            {
                frame._numbers[i] = bytes.readDouble();
                sum += frame._numbers[i] - frame._numbers[i];
            }
            frame.scaling = scaling;
            return sum == 0 && frame.unit > 0 ? frame : null;
        }

        /**
         * Takes in that a point of the model so far became the origin, and that all was divided by a length.
         *
         * @private
         */
        internal function place(x:Number, y:Number, z:Number, divisor:Number):void
        {
            // the inverse of a turn with factors along the axes that it ends in
            for (var row:int = 0; row < 9; row += 3)
            {
                var rowX:Number = _numbers[row];
                var rowY:Number = _numbers[row + 1];
                var rowZ:Number = _numbers[row + 2];
                var along:Number = row == 0 ? x : (row == 3 ? y : z);
                var share:Number = along / (rowX * rowX + rowY * rowY + rowZ * rowZ);
                for (var k:int = 0; k < 3; k++)
                {
                    _numbers[9 + k] += _numbers[row + k] * share;
                    _numbers[row + k] /= divisor;
                }
            }
            _numbers[12] *= divisor;
        }

        /**
         * Takes in a turn, about the origin, of what has no uneven scale yet.
         *
         * @private
         */
        internal function turn(rows:Vector.<Number>):void
        {
            var before:Vector.<Number> = _numbers.slice();
            for (var i:int = 0; i < 9; i++)
            {
                var row:int = i - i % 3;
                var column:int = i % 3;
                _numbers[i] = rows[row] * before[column] + rows[row + 1] * before[column + 3] + rows[row + 2] * before[column + 6];
            }
        }

        /**
         * Takes in factors along the axes.
         *
         * @private
         */
        internal function scale(factors:Vector3D):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                _numbers[i] *= factors.x;
                _numbers[i + 3] *= factors.y;
                _numbers[i + 6] *= factors.z;
            }
            _numbers[12] /= cubeRoot(Math.abs(factors.x)) * cubeRoot(Math.abs(factors.y)) * cubeRoot(Math.abs(factors.z));
        }
    }
}
