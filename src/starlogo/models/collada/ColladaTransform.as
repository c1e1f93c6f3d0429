package starlogo.models.collada
{
    import flash.geom.Vector3D;
    import starlogo.geometry.AffineTransform;
    import starlogo.geometry.Trigonometry;

    /**
     * Reads the transform elements of a COLLADA node, and the matrix of a skin, as the COLLADA 1.4 and 1.5 specifications define them. For
     * skew they refer to RenderMan.
     */
    internal final class ColladaTransform
    {
        /** How many numbers a matrix has, row by row. */
        internal static const MATRIX_SIZE:int = 16;

        // shorter parts of unit vectors are rounding
        private static const ROUNDING:Number = 1e-12;

        private static const SIZES:Object = {matrix: MATRIX_SIZE, bind_shape_matrix: MATRIX_SIZE, translate: 3, scale: 3, rotate: 4, lookat: 9, skew: 7};

        /** How many numbers an element with a name has, if it is a transform. 0 if it is none. */
        internal static function sizeOf(name:String):int
        {
            return SIZES.hasOwnProperty(name) ? SIZES[name] : 0;
        }

        /**
         * The transform of an element in a node or a skin.
         *
         * @param numbers count in place of the element's own; null for its own
         * @return null if the element is no transform
         */
        internal static function of(element:ColladaElement, numbers:Vector.<Number>):AffineTransform
        {
            var size:int = sizeOf(element.name);
            var v:Vector.<Number> = size == 0 ? null : numbers || element.numbers(size);
            switch (element.name)
            {
                case "translate":
                    return new AffineTransform(new <Number>[1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2]]);
                case "scale":
                    return new AffineTransform(new <Number>[v[0], 0, 0, 0, 0, v[1], 0, 0, 0, 0, v[2], 0]);
                case "rotate":
                    return rotation(v);
                case "lookat":
                    return lookAt(element, v);
                case "skew":
                    return skew(element, v);
                default:
                    return size == MATRIX_SIZE ? matrix(element, v) : null;
            }
        }

        /**
         * The transform with the numbers of a matrix.
         *
         * @param element names the place of an error
         * @param tolerance how far the last row may be from 0 0 0 1, in each number
         */
        internal static function matrix(element:ColladaElement, m:Vector.<Number>, tolerance:Number = 0):AffineTransform
        {
            var difference:Number = Math.max(Math.abs(m[12]), Math.abs(m[13]), Math.abs(m[14]), Math.abs(m[15] - 1));
            element.refuseIf(difference > tolerance, "expected a last row of 0 0 0 1, but found " + m.slice(12).join(" "));
            return new AffineTransform(m.slice(0, 12));
        }

        // A rotation about an axis (three numbers) by degrees (the fourth). An axis of length 0 means no rotation.
        private static function rotation(v:Vector.<Number>):AffineTransform
        {
            var axis:Vector3D = unitVector(v[0], v[1], v[2]);
            var x:Number = axis.x;
            var y:Number = axis.y;
            var z:Number = axis.z;
            var angle:Number = axis.lengthSquared > 0 ? v[3] : 0;
            var s:Number = Trigonometry.sine(angle);
            var c:Number = Trigonometry.cosine(angle);
            var t:Number = 1 - c;
            return new AffineTransform(new <Number>[
                        t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0,
                        t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0,
                        t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0]);
        }

        // The node stands at the first point, and its -z axis points at the second. The third vector points up.
        private static function lookAt(element:ColladaElement, v:Vector.<Number>):AffineTransform
        {
            var back:Vector3D = unitVector(v[0] - v[3], v[1] - v[4], v[2] - v[5]);
            var across:Vector3D = unitVector(v[6], v[7], v[8]).crossProduct(back);
            var right:Vector3D = unitVector(across.x, across.y, across.z, ROUNDING);
            var up:Vector3D = back.crossProduct(right);
            element.refuseIf(!(back.lengthSquared > 0 && right.lengthSquared > 0),
                    "expected two different points and a direction up that is not along their line");
            return new AffineTransform(new <Number>[
                        right.x, up.x, back.x, v[0],
                        right.y, up.y, back.y, v[1],
                        right.z, up.z, back.z, v[2]]);
        }

        // A skew: an angle, the axis that is turned by it, and the axis along which all points shift.
        private static function skew(element:ColladaElement, v:Vector.<Number>):AffineTransform
        {
            var d1:Vector3D = unitVector(v[1], v[2], v[3]);
            var d2:Vector3D = unitVector(v[4], v[5], v[6]);
            var cosine:Number = d1.dotProduct(d2);
            var across:Vector3D = unitVector(d1.x - cosine * d2.x, d1.y - cosine * d2.y, d1.z - cosine * d2.z, ROUNDING);
            var sine:Number = d1.dotProduct(across);
            // the sine of the angle that is left between the two
            var sineLeft:Number = sine * Trigonometry.cosine(v[0]) - cosine * Trigonometry.sine(v[0]);
            element.refuseIf(!(sine > 1e-9 && sineLeft > 1e-9),
                    "expected two different axes and an angle that leaves the first on its side of the second");
            // the difference of two cotangents; 0 for the angle 0
            d2.scaleBy(Trigonometry.sine(v[0]) / (sine * sineLeft));
            return new AffineTransform(new <Number>[
                        1 + d2.x * across.x, d2.x * across.y, d2.x * across.z, 0,
                        d2.y * across.x, 1 + d2.y * across.y, d2.y * across.z, 0,
                        d2.z * across.x, d2.z * across.y, 1 + d2.z * across.z, 0]);
        }

        // The direction of a vector, as a vector of length 1; of length 0 if no coordinate is larger than a limit. The largest coordinate is divided
        // out first, because the squares of very small or large numbers are 0 or infinite.
        private static function unitVector(x:Number, y:Number, z:Number, limit:Number = 0):Vector3D
        {
            var largest:Number = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
            if (!(largest > limit))
            {
                return new Vector3D();
            }
            x /= largest;
            y /= largest;
            z /= largest;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            return new Vector3D(x / length, y / length, z / length);
        }
    }
}
