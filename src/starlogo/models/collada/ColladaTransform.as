package starlogo.models.collada
{
    import starlogo.geometry.Trigonometry;

    /**
     * Where a node of a COLLADA scene is: x' = m00 x + m01 y + m02 z + m03 and so on, in doubles on every player. The
     * elements are those of the COLLADA 1.4 and 1.5 specifications; a skew is RenderMan's, to which these refer.
     */
    internal final class ColladaTransform
    {
        private var _m:Vector.<Number>;

        /**
         * @param rows three rows of four numbers, the last of each the translation; null for no change
         */
        public function ColladaTransform(rows:Vector.<Number> = null)
        {
            _m = rows == null ? new <Number>[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] : rows;
        }

        /**
         * The transform of an element of a node.
         *
         * @return null if the element is none that transforms
         */
        internal static function of(document:ColladaDocument, element:ColladaElement):ColladaTransform
        {
            var v:Vector.<Number>;
            switch (element.name)
            {
                case "matrix":
                    return matrix(document, element);
                case "translate":
                    v = document.numbers(element, 3);
                    return new ColladaTransform(new <Number>[1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2]]);
                case "scale":
                    v = document.numbers(element, 3);
                    return new ColladaTransform(new <Number>[v[0], 0, 0, 0, 0, v[1], 0, 0, 0, 0, v[2], 0]);
                case "rotate":
                    return rotation(document, element);
                case "lookat":
                    return lookAt(document, element);
                case "skew":
                    return skew(document, element);
                default:
                    return null;
            }
        }

        /** First another transform, then this one. */
        public function after(first:ColladaTransform):ColladaTransform
        {
            var a:Vector.<Number> = _m;
            var b:Vector.<Number> = first._m;
            var product:Vector.<Number> = new Vector.<Number>(12);
            for (var row:int = 0; row < 12; row += 4)
            {
                for (var column:int = 0; column < 4; column++)
                {
                    product[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column] +
                        (column == 3 ? a[row + 3] : 0);
                }
            }
            return new ColladaTransform(product);
        }

        /** Whether it turns left turns into right ones. */
        public function get isMirror():Boolean
        {
            return _m[0] * (_m[5] * _m[10] - _m[6] * _m[9]) - _m[1] * (_m[4] * _m[10] - _m[6] * _m[8]) +
                _m[2] * (_m[4] * _m[9] - _m[5] * _m[8]) < 0;
        }

        /**
         * Transforms some points.
         *
         * @param points x, y, z each
         * @param first the first of them
         * @param end the one behind the last
         * @param out where they go; long enough
         * @param to where in it the first one goes
         * @return whether all their coordinates are finite
         */
        public function place(points:Vector.<Number>, first:int, end:int, out:Vector.<Number>, to:int):Boolean
        {
            var m00:Number = _m[0];
            var m01:Number = _m[1];
            var m02:Number = _m[2];
            var m03:Number = _m[3];
            var m10:Number = _m[4];
            var m11:Number = _m[5];
            var m12:Number = _m[6];
            var m13:Number = _m[7];
            var m20:Number = _m[8];
            var m21:Number = _m[9];
            var m22:Number = _m[10];
            var m23:Number = _m[11];
            var at:int = 3 * to;
            var differences:Number = 0;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                var x:Number = points[i];
                var y:Number = points[j];
                var z:Number = points[k];
                var newX:Number = m00 * x + m01 * y + m02 * z + m03;
                var newY:Number = m10 * x + m11 * y + m12 * z + m13;
                var newZ:Number = m20 * x + m21 * y + m22 * z + m23;
                differences += newX - newX + newY - newY + newZ - newZ;
                out[at++] = newX;
                out[at++] = newY;
                out[at++] = newZ;
            }
            return differences == 0;
        }

        /** The transform of 16 numbers in rows. */
        internal static function matrix(document:ColladaDocument, element:ColladaElement):ColladaTransform
        {
            var m:Vector.<Number> = document.numbers(element, 16);
            if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
            {
                throw document.error(element, "expected a last row of 0 0 0 1, but found " + m.slice(12).join(" "));
            }
            return new ColladaTransform(m.slice(0, 12));
        }

        /** About an axis (three numbers) by degrees (the fourth); no axis at all is taken for no rotation. */
        private static function rotation(document:ColladaDocument, element:ColladaElement):ColladaTransform
        {
            var v:Vector.<Number> = document.numbers(element, 4);
            var length:Number = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            if (!(length > 0))
            {
                return new ColladaTransform();
            }
            var x:Number = v[0] / length;
            var y:Number = v[1] / length;
            var z:Number = v[2] / length;
            var angle:Number = v[3];
            var s:Number = Trigonometry.sine(angle);
            var c:Number = Trigonometry.cosine(angle);
            var t:Number = 1 - c;
            return new ColladaTransform(new <Number>[
                        t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0,
                        t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0,
                        t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0]);
        }

        /** Stands at the first point and looks along -z at the second; the third vector points up. */
        private static function lookAt(document:ColladaDocument, element:ColladaElement):ColladaTransform
        {
            var v:Vector.<Number> = document.numbers(element, 9);
            var back:Vector.<Number> = normalise(new <Number>[v[0] - v[3], v[1] - v[4], v[2] - v[5]]);
            var right:Vector.<Number> = normalise(cross(v.slice(6), back));
            var up:Vector.<Number> = cross(back, right);
            document.refuseIf(!(dot(back, back) > 0 && dot(right, right) > 0), element,
                    "expected two points apart and a direction up that is not along their line");
            return new ColladaTransform(new <Number>[
                        right[0], up[0], back[0], v[0],
                        right[1], up[1], back[1], v[1],
                        right[2], up[2], back[2], v[2]]);
        }

        /** An angle, the axis that turns by it, and the axis along which everything shifts. */
        private static function skew(document:ColladaDocument, element:ColladaElement):ColladaTransform
        {
            var v:Vector.<Number> = document.numbers(element, 7);
            var turning:Vector.<Number> = normalise(v.slice(1, 4));
            var shift:Vector.<Number> = normalise(v.slice(4, 7));
            var along:Number = dot(turning, shift);
            var across:Vector.<Number> = normalise(new <Number>[turning[0] - along * shift[0],
                        turning[1] - along * shift[1],
                        turning[2] - along * shift[2]]);
            var height:Number = dot(turning, across);
            var angle:Number = v[0];
            // the turned axis, in the plane of the two: across, and along the shift
            var turnedHeight:Number = height * Trigonometry.cosine(angle) - along * Trigonometry.sine(angle);
            var turnedAlong:Number = height * Trigonometry.sine(angle) + along * Trigonometry.cosine(angle);
            document.refuseIf(!(height > 1e-9 && turnedHeight > 1e-9), element,
                    "expected two axes apart and an angle that leaves the first on its side of the second");
            var amount:Number = turnedAlong / turnedHeight - along / height;
            var rows:Vector.<Number> = new Vector.<Number>(12);
            for (var row:int = 0; row < 3; row++)
            {
                for (var column:int = 0; column < 3; column++)
                {
                    rows[4 * row + column] = (row == column ? 1 : 0) + amount * shift[row] * across[column];
                }
            }
            return new ColladaTransform(rows);
        }

        private static function dot(a:Vector.<Number>, b:Vector.<Number>):Number
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        private static function cross(a:Vector.<Number>, b:Vector.<Number>):Vector.<Number>
        {
            return new <Number>[a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        }

        /** Of length 1, or zero where there is no direction. */
        private static function normalise(v:Vector.<Number>):Vector.<Number>
        {
            var length:Number = Math.sqrt(dot(v, v));
            return length > 1e-12 ? new <Number>[v[0] / length, v[1] / length, v[2] / length] : new <Number>[0, 0, 0];
        }
    }
}
