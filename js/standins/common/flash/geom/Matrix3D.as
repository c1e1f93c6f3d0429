package flash.geom
{
    import standin.SinglePrecision;

    /**
     * A 4 by 4 matrix of columns. It transforms a point (x, y, z, 1) to x * column 0 + y * column 1 + z * column 2 + column 3. To append a
     * transform means that it comes after the matrix's own, to prepend one that it comes before.
     *
     * <p>It has what the engine needs of Flash's class, and what belongs to it. Methods that return no object allocate nothing.</p>
     */
    public class Matrix3D
    {
        /**
         * Whether all matrices store their elements and return points in single precision, as in Flash Player.
         *
         * @private
         */
        public static var isSingle:Boolean = false;

        // below this, an inverse would be too large
        private static const SINGULAR:Number = 1e-11;

        private static const IDENTITY:Vector.<Number> = new <Number>[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

        private static var sRotation:Matrix3D = new Matrix3D();
        private static var sProduct:Vector.<Number> = new Vector.<Number>(16);

        private var _m:Vector.<Number> = IDENTITY.concat();

        /** @param v 16 elements, column by column; with any other number, or null, the matrix is the identity */
        public function Matrix3D(v:Vector.<Number> = null)
        {
            rawData = v;
        }

        /** A copy of the 16 elements, column by column. */
        public function get rawData():Vector.<Number>
        {
            return _m.concat();
        }

        /** Copies 16 elements. Any other number of elements, or null, changes nothing. */
        public function set rawData(v:Vector.<Number>):void
        {
            if (v != null && v.length == 16)
            {
                copyRawDataFrom(v);
            }
        }

        /** Column 3, with w = 0. */
        public function get position():Vector3D
        {
            return new Vector3D(_m[12], _m[13], _m[14]);
        }

        public function set position(pos:Vector3D):void
        {
            _m[12] = pos.x;
            _m[13] = pos.y;
            _m[14] = pos.z;
            roundIfSingle();
        }

        public function get determinant():Number
        {
            var m:Vector.<Number> = _m;
            return (m[0] * m[5] - m[4] * m[1]) * (m[10] * m[15] - m[14] * m[11]) - (m[0] * m[9] - m[8] * m[1]) * (m[6] * m[15] - m[14] * m[7])
                + (m[0] * m[13] - m[12] * m[1]) * (m[6] * m[11] - m[10] * m[7]) + (m[4] * m[9] - m[8] * m[5]) * (m[2] * m[15] - m[14] * m[3])
                - (m[4] * m[13] - m[12] * m[5]) * (m[2] * m[11] - m[10] * m[3]) + (m[8] * m[13] - m[12] * m[9]) * (m[2] * m[7] - m[6] * m[3]);
        }

        public function identity():void
        {
            setElements(IDENTITY);
        }

        public function clone():Matrix3D
        {
            var copy:Matrix3D = new Matrix3D();
            copy.copyFrom(this);
            return copy;
        }

        public function copyFrom(sourceMatrix3D:Matrix3D):void
        {
            setElements(sourceMatrix3D._m);
        }

        /**
         * Copies 16 elements, column by column; with transpose row by row.
         *
         * @param index the place of the first element in the vector
         * @throws ArgumentError if there are fewer; the matrix is then unchanged
         */
        public function copyRawDataFrom(vector:Vector.<Number>, index:uint = 0, transpose:Boolean = false):void
        {
            if (vector.length - 16 < Number(index))
            {
                throw new ArgumentError("Error #2004: One of the parameters is invalid.");
            }
            for (var i:int = 0; i < 16; i++)
            {
                _m[i] = vector[int(index + i)];
            }
            if (transpose)
            {
                this.transpose();
            }
            roundIfSingle();
        }

        /**
         * Copies the elements to a vector, column by column; with transpose row by row.
         *
         * @param index the place for the first element in the vector, which grows if necessary
         */
        public function copyRawDataTo(vector:Vector.<Number>, index:uint = 0, transpose:Boolean = false):void
        {
            if (transpose)
            {
                this.transpose();
            }
            for (var i:int = 0; i < 16; i++)
            {
                vector[int(index + i)] = _m[i];
            }
            if (transpose)
            {
                this.transpose();
            }
        }

        public function append(lhs:Matrix3D):void
        {
            setProduct(lhs, this);
        }

        public function prepend(rhs:Matrix3D):void
        {
            setProduct(this, rhs);
        }

        /** Adds to column 3. If row 3 is (0, 0, 0, 1), this is the matrix product. */
        public function appendTranslation(x:Number, y:Number, z:Number):void
        {
            _m[12] += x;
            _m[13] += y;
            _m[14] += z;
            roundIfSingle();
        }

        public function prependTranslation(x:Number, y:Number, z:Number):void
        {
            _m[12] = _m[0] * x + _m[4] * y + _m[8] * z + _m[12];
            _m[13] = _m[1] * x + _m[5] * y + _m[9] * z + _m[13];
            _m[14] = _m[2] * x + _m[6] * y + _m[10] * z + _m[14];
            _m[15] = _m[3] * x + _m[7] * y + _m[11] * z + _m[15];
            roundIfSingle();
        }

        /** @throws ArgumentError if a scale is 0; the matrix is then unchanged */
        public function appendScale(xScale:Number, yScale:Number, zScale:Number):void
        {
            checkScale(xScale, yScale, zScale);
            for (var i:int = 0; i < 16; i += 4)
            {
                _m[i] *= xScale;
                _m[int(i + 1)] *= yScale;
                _m[int(i + 2)] *= zScale;
            }
            roundIfSingle();
        }

        /** @throws ArgumentError if a scale is 0; the matrix is then unchanged */
        public function prependScale(xScale:Number, yScale:Number, zScale:Number):void
        {
            checkScale(xScale, yScale, zScale);
            for (var i:int = 0; i < 4; i++)
            {
                _m[i] *= xScale;
                _m[int(i + 4)] *= yScale;
                _m[int(i + 8)] *= zScale;
            }
            roundIfSingle();
        }

        /**
         * Appends a rotation, counter-clockwise seen from the end of the axis.
         *
         * @param axis of any length; with length 0, all points become one
         * @param pivotPoint a point on the axis; null is the origin
         */
        public function appendRotation(degrees:Number, axis:Vector3D, pivotPoint:Vector3D = null):void
        {
            sRotation.setRotation(degrees, axis, pivotPoint);
            setProduct(sRotation, this);
        }

        /** Prepends a rotation: see appendRotation. */
        public function prependRotation(degrees:Number, axis:Vector3D, pivotPoint:Vector3D = null):void
        {
            sRotation.setRotation(degrees, axis, pivotPoint);
            setProduct(this, sRotation);
        }

        public function transpose():void
        {
            for (var column:int = 1; column < 4; column++)
            {
                for (var row:int = 0; row < column; row++)
                {
                    var at:int = 4 * column + row;
                    var across:int = 4 * row + column;
                    var kept:Number = _m[at];
                    _m[at] = _m[across];
                    _m[across] = kept;
                }
            }
        }

        /** Inverts the matrix. If its determinant is within 1e-11 of 0, it is unchanged, and the result is false. */
        public function invert():Boolean
        {
            var determinant:Number = this.determinant;
            if (!(Math.abs(determinant) > SINGULAR))
            {
                return false;
            }
            var m0:Number = _m[0], m1:Number = _m[1], m2:Number = _m[2], m3:Number = _m[3];
            var m4:Number = _m[4], m5:Number = _m[5], m6:Number = _m[6], m7:Number = _m[7];
            var m8:Number = _m[8], m9:Number = _m[9], m10:Number = _m[10], m11:Number = _m[11];
            var m12:Number = _m[12], m13:Number = _m[13], m14:Number = _m[14], m15:Number = _m[15];
            // determinants of 2 by 2 parts: the numbers name the two columns, a the upper rows, b the lower rows
            var a01:Number = m0 * m5 - m4 * m1, a02:Number = m0 * m9 - m8 * m1, a03:Number = m0 * m13 - m12 * m1;
            var a12:Number = m4 * m9 - m8 * m5, a13:Number = m4 * m13 - m12 * m5, a23:Number = m8 * m13 - m12 * m9;
            var b01:Number = m2 * m7 - m6 * m3, b02:Number = m2 * m11 - m10 * m3, b03:Number = m2 * m15 - m14 * m3;
            var b12:Number = m6 * m11 - m10 * m7, b13:Number = m6 * m15 - m14 * m7, b23:Number = m10 * m15 - m14 * m11;
            var factor:Number = 1 / determinant;
            _m[0] = factor * (m5 * b23 - m9 * b13 + m13 * b12);
            _m[4] = factor * (m8 * b13 - m4 * b23 - m12 * b12);
            _m[8] = factor * (m7 * a23 - m11 * a13 + m15 * a12);
            _m[12] = factor * (m10 * a13 - m6 * a23 - m14 * a12);
            _m[1] = factor * (m9 * b03 - m1 * b23 - m13 * b02);
            _m[5] = factor * (m0 * b23 - m8 * b03 + m12 * b02);
            _m[9] = factor * (m11 * a03 - m3 * a23 - m15 * a02);
            _m[13] = factor * (m2 * a23 - m10 * a03 + m14 * a02);
            _m[2] = factor * (m1 * b13 - m5 * b03 + m13 * b01);
            _m[6] = factor * (m4 * b03 - m0 * b13 - m12 * b01);
            _m[10] = factor * (m3 * a13 - m7 * a03 + m15 * a01);
            _m[14] = factor * (m6 * a03 - m2 * a13 - m14 * a01);
            _m[3] = factor * (m5 * b02 - m1 * b12 - m9 * b01);
            _m[7] = factor * (m0 * b12 - m4 * b02 + m8 * b01);
            _m[11] = factor * (m7 * a02 - m3 * a12 - m11 * a01);
            _m[15] = factor * (m2 * a12 - m6 * a02 + m10 * a01);
            roundIfSingle();
            return true;
        }

        /** The transformed point. The point's w counts as 1. */
        public function transformVector(v:Vector3D):Vector3D
        {
            var out:Vector3D = deltaTransformVector(v);
            out.x += _m[12];
            out.y += _m[13];
            out.z += _m[14];
            out.w += _m[15];
            roundPoint(out);
            return out;
        }

        /** The vector transformed without the translation. */
        public function deltaTransformVector(v:Vector3D):Vector3D
        {
            var x:Number = v.x, y:Number = v.y, z:Number = v.z;
            var out:Vector3D = new Vector3D(_m[0] * x + _m[4] * y + _m[8] * z, _m[1] * x + _m[5] * y + _m[9] * z, _m[2] * x + _m[6] * y + _m[10] * z,
                    _m[3] * x + _m[7] * y + _m[11] * z);
            roundPoint(out);
            return out;
        }

        /**
         * Transforms a list of points. Numbers left over at the end are ignored.
         *
         * @param vin x, y, z of each point
         * @param vout may be vin; grows if necessary
         * @throws TypeError if one is null
         * @throws RangeError if vout would have to grow and is fixed; nothing is written then
         */
        public function transformVectors(vin:Vector.<Number>, vout:Vector.<Number>):void
        {
            if (vin == null || vout == null)
            {
                throw new TypeError("Error #2007: Parameter " + (vin == null ? "vin" : "vout") + " must be non-null.");
            }
            var m0:Number = _m[0], m4:Number = _m[4], m8:Number = _m[8], m12:Number = _m[12];
            var m1:Number = _m[1], m5:Number = _m[5], m9:Number = _m[9], m13:Number = _m[13];
            var m2:Number = _m[2], m6:Number = _m[6], m10:Number = _m[10], m14:Number = _m[14];
            var end:int = int(vin.length / 3) * 3;
            if (end > vout.length && vout.fixed)
            {
                throw new RangeError("Error #1126: Cannot change the length of a fixed Vector.");
            }
            for (var i:int = 0; i < end; i += 3)
            {
                var x:Number = vin[i];
                var y:Number = vin[int(i + 1)];
                var z:Number = vin[int(i + 2)];
                vout[i] = m0 * x + m4 * y + m8 * z + m12;
                vout[int(i + 1)] = m1 * x + m5 * y + m9 * z + m13;
                vout[int(i + 2)] = m2 * x + m6 * y + m10 * z + m14;
            }
            if (isSingle)
            {
                for (i = 0; i < end; i++)
                {
                    vout[i] = SinglePrecision.round(vout[i]);
                }
            }
        }

        private function setElements(elements:Vector.<Number>):void
        {
            for (var i:int = 0; i < 16; i++)
            {
                _m[i] = elements[i];
            }
        }

        /** this = left * right; either may be this. */
        private function setProduct(left:Matrix3D, right:Matrix3D):void
        {
            var l:Vector.<Number> = left._m;
            var r:Vector.<Number> = right._m;
            for (var column:int = 0; column < 16; column += 4)
            {
                var x:Number = r[column], y:Number = r[int(column + 1)], z:Number = r[int(column + 2)], w:Number = r[int(column + 3)];
                for (var row:int = 0; row < 4; row++)
                {
                    sProduct[int(column + row)] = l[row] * x + l[int(row + 4)] * y + l[int(row + 8)] * z + l[int(row + 12)] * w;
                }
            }
            setElements(sProduct);
            roundIfSingle();
        }

        /** Rodrigues' formula. If the axis makes an element 1 or 0, the result is exactly 1 or 0. */
        private function setRotation(degrees:Number, axis:Vector3D, pivot:Vector3D):void
        {
            var angle:Number = degrees * Math.PI / 180;
            var cos:Number = Math.cos(angle);
            var sin:Number = Math.sin(angle);
            var rest:Number = 1 - cos;
            var x:Number = axis.x;
            var y:Number = axis.y;
            var z:Number = axis.z;
            var xx:Number = x * x;
            var yy:Number = y * y;
            var zz:Number = z * z;
            var squared:Number = xx + yy + zz;
            if (squared != 0)
            {
                var length:Number = Math.sqrt(squared);
                x /= length;
                y /= length;
                z /= length;
                xx /= squared;
                yy /= squared;
                zz /= squared;
            }
            identity();
            _m[0] = xx + (yy + zz) * cos;
            _m[1] = x * y * rest + z * sin;
            _m[2] = x * z * rest - y * sin;
            _m[4] = x * y * rest - z * sin;
            _m[5] = yy + (xx + zz) * cos;
            _m[6] = y * z * rest + x * sin;
            _m[8] = x * z * rest + y * sin;
            _m[9] = y * z * rest - x * sin;
            _m[10] = zz + (xx + yy) * cos;
            if (pivot != null && squared != 0)
            {
                _m[12] = pivot.x - (_m[0] * pivot.x + _m[4] * pivot.y + _m[8] * pivot.z);
                _m[13] = pivot.y - (_m[1] * pivot.x + _m[5] * pivot.y + _m[9] * pivot.z);
                _m[14] = pivot.z - (_m[2] * pivot.x + _m[6] * pivot.y + _m[10] * pivot.z);
            }
        }

        private static function roundPoint(point:Vector3D):void
        {
            if (isSingle)
            {
                point.setTo(SinglePrecision.round(point.x), SinglePrecision.round(point.y), SinglePrecision.round(point.z));
                point.w = SinglePrecision.round(point.w);
            }
        }

        private function roundIfSingle():void
        {
            if (isSingle)
            {
                for (var i:int = 0; i < 16; i++)
                {
                    _m[i] = SinglePrecision.round(_m[i]);
                }
            }
        }

        private static function checkScale(x:Number, y:Number, z:Number):void
        {
            if (x == 0 || y == 0 || z == 0)
            {
                throw new ArgumentError("Error #2183: Scale values must not be zero.");
            }
        }
    }
}
