package starlogo.models.collada
{
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.AffineTransform;

    /**
     * Reads the transform elements of a COLLADA node, and the matrix of a skin, as the COLLADA 1.4 and 1.5 specifications define them. For
     * skew they refer to RenderMan.
     */
    internal final class ColladaTransform
    {
        /**
         * The transform of an element in a node or a skin.
         *
         * @return null if the element is no transform
         */
        internal static function of(element:ColladaElement):AffineTransform
        {
            var v:Vector.<Number>;
            switch (element.name)
            {
                case "matrix":
                    return matrix(element);
                case "bind_shape_matrix":
                    return matrix(element);
                case "translate":
                    v = element.numbers(3);
                    return new AffineTransform(new <Number>[1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2]]);
                case "scale":
                    v = element.numbers(3);
                    return new AffineTransform(new <Number>[v[0], 0, 0, 0, 0, v[1], 0, 0, 0, 0, v[2], 0]);
                case "rotate":
                    return rotation(element);
                case "lookat":
                    return lookAt(element);
                case "skew":
                    return skew(element);
                default:
                    return null;
            }
        }

        // The transform with 16 numbers, row by row.
        private static function matrix(element:ColladaElement):AffineTransform
        {
            var m:Vector.<Number> = element.numbers(16);
            element.refuseIf(m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1,
                    "expected a last row of 0 0 0 1, but found " + m.slice(12).join(" "));
            return new AffineTransform(m.slice(0, 12));
        }

        // A rotation about an axis (three numbers) by degrees (the fourth). An axis of length 0 means no rotation.
        private static function rotation(element:ColladaElement):AffineTransform
        {
            var v:Vector.<Number> = element.numbers(4);
            var length:Number = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            if (!(length > 0))
            {
                return new AffineTransform();
            }
            var x:Number = v[0] / length;
            var y:Number = v[1] / length;
            var z:Number = v[2] / length;
            var angle:Number = v[3];
            var s:Number = Trigonometry.sine(angle);
            var c:Number = Trigonometry.cosine(angle);
            var t:Number = 1 - c;
            return new AffineTransform(new <Number>[
                        t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0,
                        t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0,
                        t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0]);
        }

        // The node stands at the first point, and its -z axis points at the second. The third vector points up.
        private static function lookAt(element:ColladaElement):AffineTransform
        {
            var v:Vector.<Number> = element.numbers(9);
            var back:Vector.<Number> = normalise(new <Number>[v[0] - v[3], v[1] - v[4], v[2] - v[5]]);
            var right:Vector.<Number> = normalise(cross(v.slice(6), back));
            var up:Vector.<Number> = cross(back, right);
            element.refuseIf(!(dot(back, back) > 0 && dot(right, right) > 0),
                    "expected two different points and a direction up that is not along their line");
            return new AffineTransform(new <Number>[
                        right[0], up[0], back[0], v[0],
                        right[1], up[1], back[1], v[1],
                        right[2], up[2], back[2], v[2]]);
        }

        // A skew: an angle, the axis that is turned by it, and the axis along which all points shift.
        private static function skew(element:ColladaElement):AffineTransform
        {
            var v:Vector.<Number> = element.numbers(7);
            var turning:Vector.<Number> = normalise(v.slice(1, 4));
            var shift:Vector.<Number> = normalise(v.slice(4, 7));
            var along:Number = dot(turning, shift);
            var across:Vector.<Number> = normalise(new <Number>[turning[0] - along * shift[0],
                        turning[1] - along * shift[1],
                        turning[2] - along * shift[2]]);
            var height:Number = dot(turning, across);
            var angle:Number = v[0];
            // the turned axis in the plane of the two axes: its parts across the shift and along it
            var turnedHeight:Number = height * Trigonometry.cosine(angle) - along * Trigonometry.sine(angle);
            var turnedAlong:Number = height * Trigonometry.sine(angle) + along * Trigonometry.cosine(angle);
            element.refuseIf(!(height > 1e-9 && turnedHeight > 1e-9),
                    "expected two different axes and an angle that leaves the first on its side of the second");
            var amount:Number = turnedAlong / turnedHeight - along / height;
            var rows:Vector.<Number> = new Vector.<Number>(12);
            for (var row:int = 0; row < 3; row++)
            {
                for (var column:int = 0; column < 3; column++)
                {
                    rows[4 * row + column] = (row == column ? 1 : 0) + amount * shift[row] * across[column];
                }
            }
            return new AffineTransform(rows);
        }

        private static function dot(a:Vector.<Number>, b:Vector.<Number>):Number
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        private static function cross(a:Vector.<Number>, b:Vector.<Number>):Vector.<Number>
        {
            return new <Number>[a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        }

        // The vector scaled to length 1. A vector of length 0 stays 0.
        private static function normalise(v:Vector.<Number>):Vector.<Number>
        {
            var length:Number = Math.sqrt(dot(v, v));
            return length > 1e-12 ? new <Number>[v[0] / length, v[1] / length, v[2] / length] : new <Number>[0, 0, 0];
        }
    }
}
