package starlogo.models
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.data.areSameNumbers;
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
        // A matrix column by column, then x, y and z, then the unit. A point p of the source is at matrix * (p - (x, y, z)) in the model.
        private var _numbers:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];

        /** The frame of a model that equals its source. Read a model's frame from <code>Model.source</code> instead. */
        public function SourceFrame()
        {
        }

        /** The source's point that becomes the model's origin. */
        public function get offset():Vector3D
        {
            return new Vector3D(_numbers[9], _numbers[10], _numbers[11]);
        }

        /** The length of the model's unit, in units of the source. For an uneven scale it is the geometric mean. */
        public function get unit():Number
        {
            return _numbers[12];
        }

        /** The matrix that takes the source's points to the model. */
        public function get matrix():Matrix3D
        {
            var n:Vector.<Number> = _numbers;
            var columns:Vector.<Number> = new <Number>[n[0], n[1], n[2], 0, n[3], n[4], n[5], 0, n[6], n[7], n[8], 0];
            for (var row:int = 0; row < 3; row++)
            {
                columns.push(-n[row] * n[9] - n[row + 3] * n[10] - n[row + 6] * n[11]);
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
                    back.push(_numbers[3 * k + row] / squareOf(row));
                }
                back.push(_numbers[9 + k]);
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
            var n:Vector.<Number> = _numbers;
            for (var i:int = 0; i < points.length; i += 3)
            {
                out[i] = points[i] - n[9];
                out[int(i + 1)] = points[int(i + 1)] - n[10];
                out[int(i + 2)] = points[int(i + 2)] - n[11];
            }
            new AffineTransform(new <Number>[n[0], n[3], n[6], 0, n[1], n[4], n[7], 0, n[2], n[5], n[8], 0]).transformPoints(out, 0, points.length / 3, out, 0);
        }

        /**
         * Whether the other frame is equal to the last bit.
         *
         * @private
         */
        engine function equals(other:SourceFrame):Boolean
        {
            return areSameNumbers(_numbers, other._numbers);
        }

        /**
         * Writes the frame.
         *
         * @private
         */
        engine function writeTo(bytes:ByteArray):void
        {
            for (var i:int = 0; i < 13; i++)
            {
                bytes.writeDouble(_numbers[placeInFile(i)]);
            }
        }

        /**
         * Reads a frame that writeTo wrote.
         *
         * @param bytes read from its position on
         * @return null if a number is not finite, or the unit is not positive
         *
         * @private
         */
        engine static function read(bytes:ByteArray):SourceFrame
        {
            var frame:SourceFrame = new SourceFrame();
            var sum:Number = 0;
            for (var i:int = 0; i < 13; i++)
            {
                var number:Number = bytes.readDouble();
                frame._numbers[placeInFile(i)] = number;
                sum += number - number;
            }
            return sum == 0 && frame.unit > 0 ? frame : null;
        }

        /**
         * Adds a translation and a scale: the point (x, y, z) of the model so far becomes the origin, and all lengths are divided by
         * divisor.
         *
         * @private
         */
        engine function addMove(x:Number, y:Number, z:Number, divisor:Number):void
        {
            // a turn's inverse is its transpose; the factors along the new axes are divided out
            for (var row:int = 0; row < 3; row++)
            {
                var share:Number = (row == 0 ? x : (row == 1 ? y : z)) / squareOf(row);
                for (var k:int = 0; k < 3; k++)
                {
                    _numbers[9 + k] += _numbers[3 * k + row] * share;
                    _numbers[3 * k + row] /= divisor;
                }
            }
            _numbers[12] *= divisor;
        }

        /**
         * Adds a turn about the origin, or factors along the axes. A turn comes before any uneven scale.
         *
         * @param by turns or scales the model
         * @param factor how much larger that makes the model
         *
         * @private
         */
        engine function addTransform(by:AffineTransform, factor:Number):void
        {
            by.transformPoints(_numbers, 0, 3, _numbers, 0);
            _numbers[12] /= factor;
        }

        // The squared length of a row of the matrix.
        private function squareOf(row:int):Number
        {
            return _numbers[row] * _numbers[row] + _numbers[row + 3] * _numbers[row + 3] + _numbers[row + 6] * _numbers[row + 6];
        }

        // The matrix is stored row by row in a file.
        private static function placeInFile(i:int):int
        {
            return i < 9 ? i % 3 * 3 + i / 3 : i;
        }
    }
}
