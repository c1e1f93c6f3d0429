// This file is long because it has the whole of a class of Flash.
package flash.geom
{
    import standin.SinglePrecision;

    /**
     * A 4 by 4 matrix of columns. It transforms a point (x, y, z, 1) to x * column 0 + y * column 1 + z * column 2 + column 3. To append a
     * transform means that it comes after the matrix's own, to prepend one that it comes before.
     *
     * <p>Methods that return no object allocate nothing, except recompose, interpolateTo and pointAt.</p>
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

        // the names in Flash's Orientation3D
        private static const EULER_ANGLES:String = "eulerAngles";
        private static const AXIS_ANGLE:String = "axisAngle";
        private static const QUATERNION:String = "quaternion";

        private static const IDENTITY:Vector.<Number> = new <Number>[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

        private static var sRotation:Matrix3D = new Matrix3D();
        private static var sProduct:Vector.<Number> = new Vector.<Number>(16);

        private var _m:Vector.<Number> = IDENTITY.concat();

        /** @param v 16 elements, column by column; with any other number, or null, the matrix is the identity */
        public function Matrix3D(v:Vector.<Number> = null)
        {
            rawData = v;
        }

        /**
         * A matrix between two others. The translation is interpolated linearly, the rotation about one axis the shorter way round. The
         * result has no scale, because both matrices are taken as rotations. Flash does this too.
         *
         * @param percent 0 is the first matrix, 1 the second
         */
        public static function interpolate(thisMat:Matrix3D, toMat:Matrix3D, percent:Number):Matrix3D
        {
            var between:Matrix3D = thisMat.clone();
            between.interpolateTo(toMat, percent);
            return between;
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

        public function copyToMatrix3D(dest:Matrix3D):void
        {
            dest.copyFrom(this);
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
                throw invalidParameter();
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

        /** @throws ArgumentError if there is no such column */
        public function copyColumnFrom(column:uint, vector3D:Vector3D):void
        {
            copyLineFrom(column, 4 * column, 1, vector3D);
        }

        /** @throws ArgumentError if there is no such column */
        public function copyColumnTo(column:uint, vector3D:Vector3D):void
        {
            copyLineTo(column, 4 * column, 1, vector3D);
        }

        /** @throws ArgumentError if there is no such row */
        public function copyRowFrom(row:uint, vector3D:Vector3D):void
        {
            copyLineFrom(row, row, 4, vector3D);
        }

        /** @throws ArgumentError if there is no such row */
        public function copyRowTo(row:uint, vector3D:Vector3D):void
        {
            copyLineTo(row, row, 4, vector3D);
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
            scaleColumns(xScale, yScale, zScale);
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

        /**
         * The translation, rotation and scale. The method recompose makes the same matrix from them, if it has no shear. A matrix that mirrors has a
         * negative z scale. Angles are in radians.
         *
         * <p>Ruffle differs in three points. Here half a turn has an axis, an angle is never NaN if its cosine is rounded to more than 1,
         * and Euler angles have the right sign if y is a quarter turn down.</p>
         *
         * @throws Error if there is no such orientation style
         */
        public function decompose(orientationStyle:String = "eulerAngles"):Vector.<Vector3D>
        {
            checkOrientation(orientationStyle);
            var scale:Vector3D = scaleOfColumns();
            var rotation:Matrix3D = new Matrix3D();
            rotation.setUnscaled(this, scale);
            var turn:Vector3D;
            if (orientationStyle == EULER_ANGLES)
            {
                turn = rotation.toEulerAngles();
            }
            else
            {
                turn = rotation.toQuaternion();
                if (orientationStyle == AXIS_ANGLE)
                {
                    toAxisAngle(turn);
                }
            }
            return new <Vector3D>[position, turn, scale];
        }

        /**
         * Sets the matrix from a translation, rotation and scale: see decompose.
         *
         * @return whether there are three components and none is null; if not, the matrix is unchanged
         * @throws TypeError if the components are null
         * @throws Error if there is no such orientation style
         */
        public function recompose(components:Vector.<Vector3D>, orientationStyle:String = "eulerAngles"):Boolean
        {
            var count:int = components.length;
            checkOrientation(orientationStyle);
            if (count < 3 || components[0] == null || components[1] == null || components[2] == null)
            {
                return false;
            }
            var turn:Vector3D = components[1].clone();
            identity();
            if (orientationStyle == EULER_ANGLES)
            {
                setEulerAngles(turn);
            }
            else
            {
                if (orientationStyle == AXIS_ANGLE)
                {
                    turn.scaleBy(Math.sin(turn.w / 2));
                    turn.w = Math.cos(turn.w / 2);
                }
                setQuaternion(turn);
            }
            scaleColumns(components[2].x, components[2].y, components[2].z);
            position = components[0];
            return true;
        }

        /**
         * Moves and turns this matrix a part of the way to another: see interpolate.
         *
         * @param percent 0 is this matrix, 1 the other
         */
        public function interpolateTo(toMat:Matrix3D, percent:Number):void
        {
            var place:Vector3D = position;
            mix(place, toMat.position, 1 - percent, percent);
            var turn:Vector3D = toQuaternion();
            turnTowards(turn, toMat.toQuaternion(), percent);
            identity();
            setQuaternion(turn);
            position = place;
        }

        /**
         * Turns the matrix in place to face a point. Its direction <code>at</code> then points there, and its direction <code>up</code> is
         * as close as possible to the untransformed one. The scale stays. This follows Flash's documentation; Ruffle does nothing.
         *
         * @param pos the point to face, in the world; if it is the matrix's own position, nothing changes
         * @param at the object's own forward direction; null is (0, 0, -1)
         * @param up the object's own upward direction; null is (0, -1, 0)
         */
        public function pointAt(pos:Vector3D, at:Vector3D = null, up:Vector3D = null):void
        {
            var towards:Vector3D = pos.subtract(position);
            var forward:Vector3D = at == null ? new Vector3D(0, 0, -1) : at.clone();
            var upward:Vector3D = up == null ? new Vector3D(0, -1, 0) : up.clone();
            if (towards.normalize() == 0 || forward.normalize() == 0)
            {
                return;
            }
            var components:Vector.<Vector3D> = decompose();
            var own:Matrix3D = frameOf(forward, upward);
            var turned:Matrix3D = frameOf(towards, upward);
            own.transpose();
            own.append(turned);
            components[1] = own.decompose()[1];
            recompose(components);
        }

        private function setElements(elements:Vector.<Number>):void
        {
            for (var i:int = 0; i < 16; i++)
            {
                _m[i] = elements[i];
            }
        }

        /** Sets a column or row: four elements, beginning at at, step apart. */
        private function copyLineFrom(line:uint, at:int, step:int, vector3D:Vector3D):void
        {
            checkLine(line);
            _m[at] = vector3D.x;
            _m[int(at + step)] = vector3D.y;
            _m[int(at + 2 * step)] = vector3D.z;
            _m[int(at + 3 * step)] = vector3D.w;
            roundIfSingle();
        }

        private function copyLineTo(line:uint, at:int, step:int, vector3D:Vector3D):void
        {
            checkLine(line);
            vector3D.setTo(_m[at], _m[int(at + step)], _m[int(at + 2 * step)]);
            vector3D.w = _m[int(at + 3 * step)];
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

        private function scaleColumns(xScale:Number, yScale:Number, zScale:Number):void
        {
            for (var i:int = 0; i < 4; i++)
            {
                _m[i] *= xScale;
                _m[int(i + 4)] *= yScale;
                _m[int(i + 8)] *= zScale;
            }
        }

        /** The lengths of the columns. The z length is negative if the matrix mirrors. */
        private function scaleOfColumns():Vector3D
        {
            var m:Vector.<Number> = _m;
            var scale:Vector3D = new Vector3D(Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]), Math.sqrt(m[4] * m[4] + m[5] * m[5] + m[6] * m[6]),
                    Math.sqrt(m[8] * m[8] + m[9] * m[9] + m[10] * m[10]));
            if (m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]) < 0)
            {
                scale.z = -scale.z;
            }
            return scale;
        }

        /** Sets this to a matrix divided by its scale. */
        private function setUnscaled(matrix:Matrix3D, scale:Vector3D):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                _m[i] = matrix._m[i] / scale.x;
                _m[int(i + 4)] = matrix._m[int(i + 4)] / scale.y;
                _m[int(i + 8)] = matrix._m[int(i + 8)] / scale.z;
            }
        }

        private function toEulerAngles():Vector3D
        {
            if (_m[2] >= 1 || _m[2] <= -1)
            {
                // x and z turn about the same axis, so x gets the whole angle
                var isDown:Boolean = _m[2] >= 1;
                return new Vector3D(Math.atan2(isDown ? -_m[4] : _m[4], _m[5]), isDown ? -Math.PI / 2 : Math.PI / 2, 0);
            }
            return new Vector3D(Math.atan2(_m[6], _m[10]), Math.asin(-_m[2]), Math.atan2(_m[1], _m[0]));
        }

        /** The unit quaternion, by Shepperd's method, which divides by the largest of the four. */
        private function toQuaternion():Vector3D
        {
            var q:Vector3D = new Vector3D();
            if (_m[0] + _m[5] + _m[10] > 0)
            {
                q.w = Math.sqrt(1 + _m[0] + _m[5] + _m[10]) / 2;
                q.setTo((_m[6] - _m[9]) / (4 * q.w), (_m[8] - _m[2]) / (4 * q.w), (_m[1] - _m[4]) / (4 * q.w));
            }
            else if (_m[0] > _m[5] && _m[0] > _m[10])
            {
                q.x = Math.sqrt(1 + _m[0] - _m[5] - _m[10]) / 2;
                q.y = (_m[1] + _m[4]) / (4 * q.x);
                q.z = (_m[8] + _m[2]) / (4 * q.x);
                q.w = (_m[6] - _m[9]) / (4 * q.x);
            }
            else if (_m[5] > _m[10])
            {
                q.y = Math.sqrt(1 + _m[5] - _m[0] - _m[10]) / 2;
                q.x = (_m[1] + _m[4]) / (4 * q.y);
                q.z = (_m[6] + _m[9]) / (4 * q.y);
                q.w = (_m[8] - _m[2]) / (4 * q.y);
            }
            else
            {
                q.z = Math.sqrt(1 + _m[10] - _m[0] - _m[5]) / 2;
                q.x = (_m[8] + _m[2]) / (4 * q.z);
                q.y = (_m[6] + _m[9]) / (4 * q.z);
                q.w = (_m[1] - _m[4]) / (4 * q.z);
            }
            mix(q, q, 1 / Math.sqrt(q.lengthSquared + q.w * q.w), 0);
            return q;
        }

        private function setEulerAngles(turn:Vector3D):void
        {
            var cx:Number = Math.cos(turn.x), sx:Number = Math.sin(turn.x);
            var cy:Number = Math.cos(turn.y), sy:Number = Math.sin(turn.y);
            var cz:Number = Math.cos(turn.z), sz:Number = Math.sin(turn.z);
            _m[0] = cy * cz;
            _m[1] = cy * sz;
            _m[2] = -sy;
            _m[4] = sx * sy * cz - cx * sz;
            _m[5] = sx * sy * sz + cx * cz;
            _m[6] = sx * cy;
            _m[8] = cx * sy * cz + sx * sz;
            _m[9] = cx * sy * sz - sx * cz;
            _m[10] = cx * cy;
        }

        private function setQuaternion(q:Vector3D):void
        {
            var x:Number = q.x, y:Number = q.y, z:Number = q.z, w:Number = q.w;
            _m[0] = 1 - 2 * y * y - 2 * z * z;
            _m[1] = 2 * x * y + 2 * w * z;
            _m[2] = 2 * x * z - 2 * w * y;
            _m[4] = 2 * x * y - 2 * w * z;
            _m[5] = 1 - 2 * x * x - 2 * z * z;
            _m[6] = 2 * y * z + 2 * w * x;
            _m[8] = 2 * x * z + 2 * w * y;
            _m[9] = 2 * y * z - 2 * w * x;
            _m[10] = 1 - 2 * x * x - 2 * y * y;
        }

        /** The quaternion's angle, from 0 to half a turn, and its axis, which is 0 without a rotation. */
        private static function toAxisAngle(q:Vector3D):void
        {
            var isLong:Boolean = q.w < 0;
            var w:Number = isLong ? -q.w : q.w;
            if (isLong)
            {
                q.negate();
            }
            q.w = 2 * Math.atan2(q.normalize(), w);
        }

        /** Turns a quaternion towards another on the shorter arc (Shoemake's slerp). */
        private static function turnTowards(from:Vector3D, to:Vector3D, part:Number):void
        {
            var cos:Number = from.dotProduct(to) + from.w * to.w;
            var sign:Number = cos < 0 ? -1 : 1;
            var angle:Number = Math.acos(Math.min(1, cos * sign));
            var sin:Number = Math.sin(angle);
            if (sin < 1e-6)
            {
                mix(from, to, 1 - part, part * sign);
            }
            else
            {
                mix(from, to, Math.sin((1 - part) * angle) / sin, Math.sin(part * angle) * sign / sin);
            }
        }

        /** from = from * ofFrom + to * ofTo, for all four numbers. */
        private static function mix(from:Vector3D, to:Vector3D, ofFrom:Number, ofTo:Number):void
        {
            from.setTo(from.x * ofFrom + to.x * ofTo, from.y * ofFrom + to.y * ofTo, from.z * ofFrom + to.z * ofTo);
            from.w = from.w * ofFrom + to.w * ofTo;
        }

        /** A rotation whose z is the given direction, and whose y is as close as possible to up. */
        private static function frameOf(forward:Vector3D, up:Vector3D):Matrix3D
        {
            var side:Vector3D = up.crossProduct(forward);
            if (side.normalize() == 0)
            {
                side = (Math.abs(forward.x) < 0.9 ? Vector3D.X_AXIS : Vector3D.Y_AXIS).crossProduct(forward);
                side.normalize();
            }
            var frame:Matrix3D = new Matrix3D();
            var upright:Vector3D = forward.crossProduct(side);
            upright.w = side.w = 0;
            frame.copyColumnFrom(0, side);
            frame.copyColumnFrom(1, upright);
            frame.copyColumnFrom(2, new Vector3D(forward.x, forward.y, forward.z));
            return frame;
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

        private static function checkOrientation(style:String):void
        {
            if (style != EULER_ANGLES && style != AXIS_ANGLE && style != QUATERNION)
            {
                throw new Error("Error #2187: Invalid orientation style " + style + ".  Value must be one of "
                        + "'Orientation3D.EULER_ANGLES', 'Orientation3D.AXIS_ANGLE', or 'Orientation3D.QUATERNION'.");
            }
        }

        private static function checkScale(x:Number, y:Number, z:Number):void
        {
            if (x == 0 || y == 0 || z == 0)
            {
                throw new ArgumentError("Error #2183: Scale values must not be zero.");
            }
        }

        private static function checkLine(line:uint):void
        {
            if (line > 3)
            {
                throw invalidParameter();
            }
        }

        private static function invalidParameter():Error
        {
            return new ArgumentError("Error #2004: One of the parameters is invalid.");
        }
    }
}
