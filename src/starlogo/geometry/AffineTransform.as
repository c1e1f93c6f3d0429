package starlogo.geometry
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * An affine transform of points, for example from a node's space to the scene's. x' = m00 x + m01 y + m02 z + m03, and the next two rows give
     * y' and z'. All numbers are doubles on every player.
     *
     * @private
     */
    public final class AffineTransform
    {
        private static const POINTS_PER_STEP:int = 4000;

        /** Three rows of four numbers. The last number of each row is the translation. */
        public var rows:Vector.<Number>;

        /** @param rows three rows of four numbers, the last of each row the translation; null for no change */
        public function AffineTransform(rows:Vector.<Number> = null)
        {
            this.rows = rows == null ? new <Number>[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] : rows;
        }

        /** A transform that scales first, then rotates, then moves. @param rotation gives the rotation */
        public static function of(rotation:Placement, scaleX:Number = 1, scaleY:Number = 1, scaleZ:Number = 1, x:Number = 0, y:Number = 0, z:Number = 0):AffineTransform
        {
            return new AffineTransform(new <Number>[
                        rotation.r00 * scaleX, rotation.r01 * scaleY, rotation.r02 * scaleZ, x,
                        rotation.r10 * scaleX, rotation.r11 * scaleY, rotation.r12 * scaleZ, y,
                        rotation.r20 * scaleX, rotation.r21 * scaleY, rotation.r22 * scaleZ, z]);
        }

        /**
         * The rotation that makes an axis point up along z. If y is up, -z becomes y. If x is up, -y becomes x and -z becomes y. (The COLLADA
         * specification's table for up_axis gives the right and inward axes.)
         *
         * @param upAxis the axis that points up: "x", "y" or "z"
         */
        public static function toZUp(upAxis:String):AffineTransform
        {
            switch (upAxis)
            {
                case "x":
                    return new AffineTransform(new <Number>[0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0]);
                case "y":
                    return new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
                default:
                    return new AffineTransform();
            }
        }

        /** Returns the transform that applies the given one first and then this one. */
        public function after(first:AffineTransform):AffineTransform
        {
            var a:Vector.<Number> = rows;
            var b:Vector.<Number> = first.rows;
            var product:Vector.<Number> = new Vector.<Number>(12);
            for (var row:int = 0; row < 12; row += 4)
            {
                for (var column:int = 0; column < 4; column++)
                {
                    product[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column] +
                        (column == 3 ? a[row + 3] : 0);
                }
            }
            return new AffineTransform(product);
        }

        /** Divides all numbers. */
        public function divideBy(divisor:Number):void
        {
            for (var i:int = 0; i < 12; i++)
            {
                rows[i] /= divisor;
            }
        }

        /** Whether it mirrors: a left hand becomes a right hand. */
        public function get isMirror():Boolean
        {
            var m:Vector.<Number> = rows.concat();
            // products of very small or very large numbers would be 0 or infinite
            for (var i:int = 0; i < 3; i++)
            {
                scaleToOne(m, i, 4);
            }
            for (i = 0; i < 3; i++)
            {
                scaleToOne(m, 4 * i, 1);
            }
            return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]) < 0;
        }

        // Divides three numbers by the largest of their sizes, unless all are 0.
        private static function scaleToOne(numbers:Vector.<Number>, first:int, step:int):void
        {
            var second:int = first + step;
            var third:int = second + step;
            var largest:Number = Math.max(Math.abs(numbers[first]), Math.max(Math.abs(numbers[second]), Math.abs(numbers[third])));
            if (largest > 0)
            {
                numbers[first] /= largest;
                numbers[second] /= largest;
                numbers[third] /= largest;
            }
        }

        /** The steps that transform all of the points in place. */
        public function transformingPoints(points:Vector.<Number>):Steps
        {
            return new StepSequence().slices(points.length / 3, POINTS_PER_STEP, function(first:int, end:int):void
                {
                    transformPoints(points, first, end, points, first);
                });
        }

        /**
         * Transforms the points from one index up to another.
         *
         * @param points x, y, z of each point
         * @param first the index of the first point
         * @param end the index after the last point
         * @param out takes the results; long enough; may be the same vector as points
         * @param to the index in out for the first point
         * @return whether all new coordinates are finite
         */
        public function transformPoints(points:Vector.<Number>, first:int, end:int, out:Vector.<Number>, to:int):Boolean
        {
            var m:Vector.<Number> = rows;
            var at:int = 3 * to;
            var differences:Number = 0;
            for (var i:int = 3 * first; i < 3 * end; i += 3)
            {
                var x:Number = points[i];
                var y:Number = points[int(i + 1)];
                var z:Number = points[int(i + 2)];
                var newX:Number = m[0] * x + m[1] * y + m[2] * z + m[3];
                var newY:Number = m[4] * x + m[5] * y + m[6] * z + m[7];
                var newZ:Number = m[8] * x + m[9] * y + m[10] * z + m[11];
                differences += newX - newX + newY - newY + newZ - newZ;
                out[at++] = newX;
                out[at++] = newY;
                out[at++] = newZ;
            }
            return differences == 0;
        }
    }
}
