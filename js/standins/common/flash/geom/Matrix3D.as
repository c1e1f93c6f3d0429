// This file is long because it has the whole of a class of Flash, written out: its loops would cost more than they do.
package flash.geom
{
    import standin.SinglePrecision;

    /**
     * A 4 by 4 matrix of columns. It transforms a point (x, y, z, 1) to x * column 0 + y * column 1 + z * column 2 + column 3;
     * appending a transform does that after what the matrix did so far, prepending before.
     *
     * <p>Methods that return no object allocate nothing, but for recompose, interpolateTo and pointAt.</p>
     */
    public class Matrix3D
    {
        /**
         * Whether every matrix keeps its elements, and hands out points, in single precision, as Flash Player does.
         *
         * @private
         */
        public static var isSingle:Boolean = false;

        // an inverse would be too large
        private static const SINGULAR:Number = 1e-11;

        private static var sRotation:Matrix3D = new Matrix3D();

        private var _m0:Number;
        private var _m1:Number;
        private var _m2:Number;
        private var _m3:Number;
        private var _m4:Number;
        private var _m5:Number;
        private var _m6:Number;
        private var _m7:Number;
        private var _m8:Number;
        private var _m9:Number;
        private var _m10:Number;
        private var _m11:Number;
        private var _m12:Number;
        private var _m13:Number;
        private var _m14:Number;
        private var _m15:Number;

        /** @param v 16 elements, column by column; with any other number, or null, the matrix is the identity */
        public function Matrix3D(v:Vector.<Number> = null)
        {
            identity();
            rawData = v;
        }

        /**
         * A matrix so much of the way from one to another: the translation in proportion, the rotation about one axis, the
         * shorter way round. It has no scale; the matrices are taken for rotations. Flash does so too.
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
            var copy:Vector.<Number> = new Vector.<Number>(16);
            copyRawDataTo(copy);
            return copy;
        }

        /** Takes 16 elements over; any other number of them, or null, changes nothing. */
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
            return new Vector3D(_m12, _m13, _m14);
        }

        public function set position(pos:Vector3D):void
        {
            _m12 = pos.x;
            _m13 = pos.y;
            _m14 = pos.z;
            roundIfSingle();
        }

        public function get determinant():Number
        {
            return (_m0 * _m5 - _m4 * _m1) * (_m10 * _m15 - _m14 * _m11) - (_m0 * _m9 - _m8 * _m1) * (_m6 * _m15 - _m14 * _m7)
                + (_m0 * _m13 - _m12 * _m1) * (_m6 * _m11 - _m10 * _m7) + (_m4 * _m9 - _m8 * _m5) * (_m2 * _m15 - _m14 * _m3)
                - (_m4 * _m13 - _m12 * _m5) * (_m2 * _m11 - _m10 * _m3) + (_m8 * _m13 - _m12 * _m9) * (_m2 * _m7 - _m6 * _m3);
        }

        public function identity():void
        {
            _m0 = _m5 = _m10 = _m15 = 1;
            _m1 = _m2 = _m3 = _m4 = _m6 = _m7 = _m8 = _m9 = _m11 = _m12 = _m13 = _m14 = 0;
        }

        public function clone():Matrix3D
        {
            var copy:Matrix3D = new Matrix3D();
            copy.copyFrom(this);
            return copy;
        }

        public function copyFrom(sourceMatrix3D:Matrix3D):void
        {
            _m0 = sourceMatrix3D._m0;
            _m1 = sourceMatrix3D._m1;
            _m2 = sourceMatrix3D._m2;
            _m3 = sourceMatrix3D._m3;
            _m4 = sourceMatrix3D._m4;
            _m5 = sourceMatrix3D._m5;
            _m6 = sourceMatrix3D._m6;
            _m7 = sourceMatrix3D._m7;
            _m8 = sourceMatrix3D._m8;
            _m9 = sourceMatrix3D._m9;
            _m10 = sourceMatrix3D._m10;
            _m11 = sourceMatrix3D._m11;
            _m12 = sourceMatrix3D._m12;
            _m13 = sourceMatrix3D._m13;
            _m14 = sourceMatrix3D._m14;
            _m15 = sourceMatrix3D._m15;
        }

        public function copyToMatrix3D(dest:Matrix3D):void
        {
            dest.copyFrom(this);
        }

        /**
         * Takes 16 elements over, column by column, with transpose row by row.
         *
         * @param index the place of the first element in the vector
         * @throws ArgumentError if there are fewer; the matrix stays
         */
        public function copyRawDataFrom(vector:Vector.<Number>, index:uint = 0, transpose:Boolean = false):void
        {
            if (vector.length - 16 < Number(index))
            {
                throw invalidParameter();
            }
            _m0 = vector[index];
            _m1 = vector[int(index + 1)];
            _m2 = vector[int(index + 2)];
            _m3 = vector[int(index + 3)];
            _m4 = vector[int(index + 4)];
            _m5 = vector[int(index + 5)];
            _m6 = vector[int(index + 6)];
            _m7 = vector[int(index + 7)];
            _m8 = vector[int(index + 8)];
            _m9 = vector[int(index + 9)];
            _m10 = vector[int(index + 10)];
            _m11 = vector[int(index + 11)];
            _m12 = vector[int(index + 12)];
            _m13 = vector[int(index + 13)];
            _m14 = vector[int(index + 14)];
            _m15 = vector[int(index + 15)];
            if (transpose)
            {
                this.transpose();
            }
            roundIfSingle();
        }

        /**
         * Hands the elements out, column by column, with transpose row by row.
         *
         * @param index the place of the first element in the vector, which grows if need be
         */
        public function copyRawDataTo(vector:Vector.<Number>, index:uint = 0, transpose:Boolean = false):void
        {
            if (transpose)
            {
                this.transpose();
            }
            vector[index] = _m0;
            vector[int(index + 1)] = _m1;
            vector[int(index + 2)] = _m2;
            vector[int(index + 3)] = _m3;
            vector[int(index + 4)] = _m4;
            vector[int(index + 5)] = _m5;
            vector[int(index + 6)] = _m6;
            vector[int(index + 7)] = _m7;
            vector[int(index + 8)] = _m8;
            vector[int(index + 9)] = _m9;
            vector[int(index + 10)] = _m10;
            vector[int(index + 11)] = _m11;
            vector[int(index + 12)] = _m12;
            vector[int(index + 13)] = _m13;
            vector[int(index + 14)] = _m14;
            vector[int(index + 15)] = _m15;
            if (transpose)
            {
                this.transpose();
            }
        }

        /** @throws ArgumentError if there is no such column */
        public function copyColumnFrom(column:uint, vector3D:Vector3D):void
        {
            switch (column)
            {
                case 0:
                    _m0 = vector3D.x;
                    _m1 = vector3D.y;
                    _m2 = vector3D.z;
                    _m3 = vector3D.w;
                    break;
                case 1:
                    _m4 = vector3D.x;
                    _m5 = vector3D.y;
                    _m6 = vector3D.z;
                    _m7 = vector3D.w;
                    break;
                case 2:
                    _m8 = vector3D.x;
                    _m9 = vector3D.y;
                    _m10 = vector3D.z;
                    _m11 = vector3D.w;
                    break;
                case 3:
                    _m12 = vector3D.x;
                    _m13 = vector3D.y;
                    _m14 = vector3D.z;
                    _m15 = vector3D.w;
                    break;
                default:
                    throw invalidParameter();
            }
            roundIfSingle();
        }

        /** @throws ArgumentError if there is no such column */
        public function copyColumnTo(column:uint, vector3D:Vector3D):void
        {
            switch (column)
            {
                case 0:
                    vector3D.setTo(_m0, _m1, _m2);
                    vector3D.w = _m3;
                    break;
                case 1:
                    vector3D.setTo(_m4, _m5, _m6);
                    vector3D.w = _m7;
                    break;
                case 2:
                    vector3D.setTo(_m8, _m9, _m10);
                    vector3D.w = _m11;
                    break;
                case 3:
                    vector3D.setTo(_m12, _m13, _m14);
                    vector3D.w = _m15;
                    break;
                default:
                    throw invalidParameter();
            }
        }

        /** @throws ArgumentError if there is no such row */
        public function copyRowFrom(row:uint, vector3D:Vector3D):void
        {
            transpose();
            try
            {
                copyColumnFrom(row, vector3D);
            }
            finally
            {
                transpose();
            }
        }

        /** @throws ArgumentError if there is no such row */
        public function copyRowTo(row:uint, vector3D:Vector3D):void
        {
            transpose();
            try
            {
                copyColumnTo(row, vector3D);
            }
            finally
            {
                transpose();
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

        /** Adds to column 3, which is the product wherever row 3 is (0, 0, 0, 1). */
        public function appendTranslation(x:Number, y:Number, z:Number):void
        {
            _m12 += x;
            _m13 += y;
            _m14 += z;
            roundIfSingle();
        }

        public function prependTranslation(x:Number, y:Number, z:Number):void
        {
            _m12 = _m0 * x + _m4 * y + _m8 * z + _m12;
            _m13 = _m1 * x + _m5 * y + _m9 * z + _m13;
            _m14 = _m2 * x + _m6 * y + _m10 * z + _m14;
            _m15 = _m3 * x + _m7 * y + _m11 * z + _m15;
            roundIfSingle();
        }

        /** @throws ArgumentError if a scale is 0; the matrix stays */
        public function appendScale(xScale:Number, yScale:Number, zScale:Number):void
        {
            checkScale(xScale, yScale, zScale);
            _m0 *= xScale;
            _m4 *= xScale;
            _m8 *= xScale;
            _m12 *= xScale;
            _m1 *= yScale;
            _m5 *= yScale;
            _m9 *= yScale;
            _m13 *= yScale;
            _m2 *= zScale;
            _m6 *= zScale;
            _m10 *= zScale;
            _m14 *= zScale;
            roundIfSingle();
        }

        /** @throws ArgumentError if a scale is 0; the matrix stays */
        public function prependScale(xScale:Number, yScale:Number, zScale:Number):void
        {
            checkScale(xScale, yScale, zScale);
            scaleColumns(xScale, yScale, zScale);
            roundIfSingle();
        }

        /**
         * Appends a rotation, counter-clockwise to whoever looks against the axis.
         *
         * @param axis of any length; one without length makes all points one
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
            var kept:Number = _m1;
            _m1 = _m4;
            _m4 = kept;
            kept = _m2;
            _m2 = _m8;
            _m8 = kept;
            kept = _m3;
            _m3 = _m12;
            _m12 = kept;
            kept = _m6;
            _m6 = _m9;
            _m9 = kept;
            kept = _m7;
            _m7 = _m13;
            _m13 = kept;
            kept = _m11;
            _m11 = _m14;
            _m14 = kept;
        }

        /** Inverts the matrix; one whose determinant is within 1e-11 of 0 stays as it is, and false is returned. */
        public function invert():Boolean
        {
            var determinant:Number = this.determinant;
            if (!(Math.abs(determinant) > SINGULAR))
            {
                return false;
            }
            var m0:Number = _m0, m1:Number = _m1, m2:Number = _m2, m3:Number = _m3;
            var m4:Number = _m4, m5:Number = _m5, m6:Number = _m6, m7:Number = _m7;
            var m8:Number = _m8, m9:Number = _m9, m10:Number = _m10, m11:Number = _m11;
            var m12:Number = _m12, m13:Number = _m13, m14:Number = _m14, m15:Number = _m15;
            // the determinants of two rows of two columns, named by both columns, of the upper (a) and lower (b) rows
            var a01:Number = m0 * m5 - m4 * m1, a02:Number = m0 * m9 - m8 * m1, a03:Number = m0 * m13 - m12 * m1;
            var a12:Number = m4 * m9 - m8 * m5, a13:Number = m4 * m13 - m12 * m5, a23:Number = m8 * m13 - m12 * m9;
            var b01:Number = m2 * m7 - m6 * m3, b02:Number = m2 * m11 - m10 * m3, b03:Number = m2 * m15 - m14 * m3;
            var b12:Number = m6 * m11 - m10 * m7, b13:Number = m6 * m15 - m14 * m7, b23:Number = m10 * m15 - m14 * m11;
            var factor:Number = 1 / determinant;
            _m0 = factor * (m5 * b23 - m9 * b13 + m13 * b12);
            _m4 = factor * (m8 * b13 - m4 * b23 - m12 * b12);
            _m8 = factor * (m7 * a23 - m11 * a13 + m15 * a12);
            _m12 = factor * (m10 * a13 - m6 * a23 - m14 * a12);
            _m1 = factor * (m9 * b03 - m1 * b23 - m13 * b02);
            _m5 = factor * (m0 * b23 - m8 * b03 + m12 * b02);
            _m9 = factor * (m11 * a03 - m3 * a23 - m15 * a02);
            _m13 = factor * (m2 * a23 - m10 * a03 + m14 * a02);
            _m2 = factor * (m1 * b13 - m5 * b03 + m13 * b01);
            _m6 = factor * (m4 * b03 - m0 * b13 - m12 * b01);
            _m10 = factor * (m3 * a13 - m7 * a03 + m15 * a01);
            _m14 = factor * (m6 * a03 - m2 * a13 - m14 * a01);
            _m3 = factor * (m5 * b02 - m1 * b12 - m9 * b01);
            _m7 = factor * (m0 * b12 - m4 * b02 + m8 * b01);
            _m11 = factor * (m7 * a02 - m3 * a12 - m11 * a01);
            _m15 = factor * (m2 * a12 - m6 * a02 + m10 * a01);
            roundIfSingle();
            return true;
        }

        /** The point transformed, its own w taken for 1. */
        public function transformVector(v:Vector3D):Vector3D
        {
            var out:Vector3D = deltaTransformVector(v);
            out.x += _m12;
            out.y += _m13;
            out.z += _m14;
            out.w += _m15;
            roundPoint(out);
            return out;
        }

        /** The vector transformed without the translation. */
        public function deltaTransformVector(v:Vector3D):Vector3D
        {
            var x:Number = v.x, y:Number = v.y, z:Number = v.z;
            var out:Vector3D = new Vector3D(_m0 * x + _m4 * y + _m8 * z, _m1 * x + _m5 * y + _m9 * z, _m2 * x + _m6 * y + _m10 * z,
                    _m3 * x + _m7 * y + _m11 * z);
            roundPoint(out);
            return out;
        }

        /**
         * Transforms points in a row; numbers left over at the end are not read.
         *
         * @param vin x, y, z of each point
         * @param vout may be vin; grows if need be
         * @throws TypeError if one is null
         * @throws RangeError if vout would have to grow and must not; nothing is written then
         */
        public function transformVectors(vin:Vector.<Number>, vout:Vector.<Number>):void
        {
            if (vin == null || vout == null)
            {
                throw new TypeError("Error #2007: Parameter " + (vin == null ? "vin" : "vout") + " must be non-null.");
            }
            var m0:Number = _m0, m4:Number = _m4, m8:Number = _m8, m12:Number = _m12;
            var m1:Number = _m1, m5:Number = _m5, m9:Number = _m9, m13:Number = _m13;
            var m2:Number = _m2, m6:Number = _m6, m10:Number = _m10, m14:Number = _m14;
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
         * Translation, rotation and scale, which recompose makes the matrix of again if it has no shear. A matrix that mirrors
         * has a negative z scale. Angles are in radians.
         *
         * <p>Half a turn has an axis here, and an angle whose cosine is rounded beyond 1 is no NaN; Ruffle differs in both, and
         * gives Euler angles with the wrong sign where y is a quarter turn down.</p>
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
            if (orientationStyle == Orientation3D.EULER_ANGLES)
            {
                turn = rotation.toEulerAngles();
            }
            else
            {
                turn = rotation.toQuaternion();
                if (orientationStyle == Orientation3D.AXIS_ANGLE)
                {
                    toAxisAngle(turn);
                }
            }
            return new <Vector3D>[position, turn, scale];
        }

        /**
         * Makes this the matrix of a translation, rotation and scale: see decompose.
         *
         * @return whether there are three components and none is null; if not, the matrix stays
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
            if (orientationStyle == Orientation3D.EULER_ANGLES)
            {
                setEulerAngles(turn);
            }
            else
            {
                if (orientationStyle == Orientation3D.AXIS_ANGLE)
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
         * Moves and turns this matrix so much of the way to another: see interpolate.
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
         * Turns what the matrix transforms, where it stands, to face a point: its direction <code>at</code> then shows there, and
         * its direction <code>up</code> as near as may be to where it shows untransformed. The scale stays. This follows
         * Flash's documentation; Ruffle does nothing.
         *
         * @param pos the point to face, in the world; where it is the matrix's own position nothing changes
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

        /** this = left * right; either may be this. */
        private function setProduct(left:Matrix3D, right:Matrix3D):void
        {
            var l0:Number = left._m0, l1:Number = left._m1, l2:Number = left._m2, l3:Number = left._m3;
            var l4:Number = left._m4, l5:Number = left._m5, l6:Number = left._m6, l7:Number = left._m7;
            var l8:Number = left._m8, l9:Number = left._m9, l10:Number = left._m10, l11:Number = left._m11;
            var l12:Number = left._m12, l13:Number = left._m13, l14:Number = left._m14, l15:Number = left._m15;
            var x:Number = right._m0, y:Number = right._m1, z:Number = right._m2, w:Number = right._m3;
            _m0 = l0 * x + l4 * y + l8 * z + l12 * w;
            _m1 = l1 * x + l5 * y + l9 * z + l13 * w;
            _m2 = l2 * x + l6 * y + l10 * z + l14 * w;
            _m3 = l3 * x + l7 * y + l11 * z + l15 * w;
            x = right._m4;
            y = right._m5;
            z = right._m6;
            w = right._m7;
            _m4 = l0 * x + l4 * y + l8 * z + l12 * w;
            _m5 = l1 * x + l5 * y + l9 * z + l13 * w;
            _m6 = l2 * x + l6 * y + l10 * z + l14 * w;
            _m7 = l3 * x + l7 * y + l11 * z + l15 * w;
            x = right._m8;
            y = right._m9;
            z = right._m10;
            w = right._m11;
            _m8 = l0 * x + l4 * y + l8 * z + l12 * w;
            _m9 = l1 * x + l5 * y + l9 * z + l13 * w;
            _m10 = l2 * x + l6 * y + l10 * z + l14 * w;
            _m11 = l3 * x + l7 * y + l11 * z + l15 * w;
            x = right._m12;
            y = right._m13;
            z = right._m14;
            w = right._m15;
            _m12 = l0 * x + l4 * y + l8 * z + l12 * w;
            _m13 = l1 * x + l5 * y + l9 * z + l13 * w;
            _m14 = l2 * x + l6 * y + l10 * z + l14 * w;
            _m15 = l3 * x + l7 * y + l11 * z + l15 * w;
            roundIfSingle();
        }

        /** Rodrigues' formula, such that what the axis's own numbers make 1 or 0 is just that. */
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
            _m0 = xx + (yy + zz) * cos;
            _m1 = x * y * rest + z * sin;
            _m2 = x * z * rest - y * sin;
            _m4 = x * y * rest - z * sin;
            _m5 = yy + (xx + zz) * cos;
            _m6 = y * z * rest + x * sin;
            _m8 = x * z * rest + y * sin;
            _m9 = y * z * rest - x * sin;
            _m10 = zz + (xx + yy) * cos;
            if (pivot != null && squared != 0)
            {
                _m12 = pivot.x - (_m0 * pivot.x + _m4 * pivot.y + _m8 * pivot.z);
                _m13 = pivot.y - (_m1 * pivot.x + _m5 * pivot.y + _m9 * pivot.z);
                _m14 = pivot.z - (_m2 * pivot.x + _m6 * pivot.y + _m10 * pivot.z);
            }
        }

        private function scaleColumns(xScale:Number, yScale:Number, zScale:Number):void
        {
            _m0 *= xScale;
            _m1 *= xScale;
            _m2 *= xScale;
            _m3 *= xScale;
            _m4 *= yScale;
            _m5 *= yScale;
            _m6 *= yScale;
            _m7 *= yScale;
            _m8 *= zScale;
            _m9 *= zScale;
            _m10 *= zScale;
            _m11 *= zScale;
        }

        /** The columns' lengths; that of z negative if the matrix mirrors. */
        private function scaleOfColumns():Vector3D
        {
            var scale:Vector3D = new Vector3D(Math.sqrt(_m0 * _m0 + _m1 * _m1 + _m2 * _m2), Math.sqrt(_m4 * _m4 + _m5 * _m5 + _m6 * _m6),
                    Math.sqrt(_m8 * _m8 + _m9 * _m9 + _m10 * _m10));
            if (_m0 * (_m5 * _m10 - _m6 * _m9) - _m1 * (_m4 * _m10 - _m6 * _m8) + _m2 * (_m4 * _m9 - _m5 * _m8) < 0)
            {
                scale.z = -scale.z;
            }
            return scale;
        }

        /** The rotation of a matrix with such a scale. */
        private function setUnscaled(matrix:Matrix3D, scale:Vector3D):void
        {
            _m0 = matrix._m0 / scale.x;
            _m1 = matrix._m1 / scale.x;
            _m2 = matrix._m2 / scale.x;
            _m4 = matrix._m4 / scale.y;
            _m5 = matrix._m5 / scale.y;
            _m6 = matrix._m6 / scale.y;
            _m8 = matrix._m8 / scale.z;
            _m9 = matrix._m9 / scale.z;
            _m10 = matrix._m10 / scale.z;
        }

        private function toEulerAngles():Vector3D
        {
            if (_m2 >= 1 || _m2 <= -1)
            {
                // x and z turn about the same axis: all of it is x's
                var isDown:Boolean = _m2 >= 1;
                return new Vector3D(Math.atan2(isDown ? -_m4 : _m4, _m5), isDown ? -Math.PI / 2 : Math.PI / 2, 0);
            }
            return new Vector3D(Math.atan2(_m6, _m10), Math.asin(-_m2), Math.atan2(_m1, _m0));
        }

        /** Of length 1, by Shepperd's method: divides by the largest of the four. */
        private function toQuaternion():Vector3D
        {
            var q:Vector3D = new Vector3D();
            if (_m0 + _m5 + _m10 > 0)
            {
                q.w = Math.sqrt(1 + _m0 + _m5 + _m10) / 2;
                q.setTo((_m6 - _m9) / (4 * q.w), (_m8 - _m2) / (4 * q.w), (_m1 - _m4) / (4 * q.w));
            }
            else if (_m0 > _m5 && _m0 > _m10)
            {
                q.x = Math.sqrt(1 + _m0 - _m5 - _m10) / 2;
                q.y = (_m1 + _m4) / (4 * q.x);
                q.z = (_m8 + _m2) / (4 * q.x);
                q.w = (_m6 - _m9) / (4 * q.x);
            }
            else if (_m5 > _m10)
            {
                q.y = Math.sqrt(1 + _m5 - _m0 - _m10) / 2;
                q.x = (_m1 + _m4) / (4 * q.y);
                q.z = (_m6 + _m9) / (4 * q.y);
                q.w = (_m8 - _m2) / (4 * q.y);
            }
            else
            {
                q.z = Math.sqrt(1 + _m10 - _m0 - _m5) / 2;
                q.x = (_m8 + _m2) / (4 * q.z);
                q.y = (_m6 + _m9) / (4 * q.z);
                q.w = (_m1 - _m4) / (4 * q.z);
            }
            mix(q, q, 1 / Math.sqrt(q.lengthSquared + q.w * q.w), 0);
            return q;
        }

        private function setEulerAngles(turn:Vector3D):void
        {
            var cx:Number = Math.cos(turn.x), sx:Number = Math.sin(turn.x);
            var cy:Number = Math.cos(turn.y), sy:Number = Math.sin(turn.y);
            var cz:Number = Math.cos(turn.z), sz:Number = Math.sin(turn.z);
            _m0 = cy * cz;
            _m1 = cy * sz;
            _m2 = -sy;
            _m4 = sx * sy * cz - cx * sz;
            _m5 = sx * sy * sz + cx * cz;
            _m6 = sx * cy;
            _m8 = cx * sy * cz + sx * sz;
            _m9 = cx * sy * sz - sx * cz;
            _m10 = cx * cy;
        }

        private function setQuaternion(q:Vector3D):void
        {
            var x:Number = q.x, y:Number = q.y, z:Number = q.z, w:Number = q.w;
            _m0 = 1 - 2 * y * y - 2 * z * z;
            _m1 = 2 * x * y + 2 * w * z;
            _m2 = 2 * x * z - 2 * w * y;
            _m4 = 2 * x * y - 2 * w * z;
            _m5 = 1 - 2 * x * x - 2 * z * z;
            _m6 = 2 * y * z + 2 * w * x;
            _m8 = 2 * x * z + 2 * w * y;
            _m9 = 2 * y * z - 2 * w * x;
            _m10 = 1 - 2 * x * x - 2 * y * y;
        }

        /** The quaternion's angle, from 0 to half a turn, and its axis: none where there is no rotation. */
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

        /** Turns a quaternion to another on the shorter arc (Shoemake's slerp). */
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

        /** from = from * ofFrom + to * ofTo, in all four numbers. */
        private static function mix(from:Vector3D, to:Vector3D, ofFrom:Number, ofTo:Number):void
        {
            from.setTo(from.x * ofFrom + to.x * ofTo, from.y * ofFrom + to.y * ofTo, from.z * ofFrom + to.z * ofTo);
            from.w = from.w * ofFrom + to.w * ofTo;
        }

        /** A rotation whose z is a direction, and whose y is as near to another as may be. */
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
                _m0 = SinglePrecision.round(_m0);
                _m1 = SinglePrecision.round(_m1);
                _m2 = SinglePrecision.round(_m2);
                _m3 = SinglePrecision.round(_m3);
                _m4 = SinglePrecision.round(_m4);
                _m5 = SinglePrecision.round(_m5);
                _m6 = SinglePrecision.round(_m6);
                _m7 = SinglePrecision.round(_m7);
                _m8 = SinglePrecision.round(_m8);
                _m9 = SinglePrecision.round(_m9);
                _m10 = SinglePrecision.round(_m10);
                _m11 = SinglePrecision.round(_m11);
                _m12 = SinglePrecision.round(_m12);
                _m13 = SinglePrecision.round(_m13);
                _m14 = SinglePrecision.round(_m14);
                _m15 = SinglePrecision.round(_m15);
            }
        }

        private static function checkOrientation(style:String):void
        {
            if (style != Orientation3D.EULER_ANGLES && style != Orientation3D.AXIS_ANGLE && style != Orientation3D.QUATERNION)
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

        private static function invalidParameter():Error
        {
            return new ArgumentError("Error #2004: One of the parameters is invalid.");
        }
    }
}
