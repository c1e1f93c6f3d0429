// The room geometry has the plain maths that all others share: placements, and functions with the same results on every machine. Read Placement first,
// then Touching, which says when two shapes touch. Tolerances has the limits for rounding, in groups. The folder vertices is for lists of points: the box
// around them, which of them are the same, what is wrong with them. The folder hull builds convex hulls: read ConvexHull, then QuickHull.

package starlogo.geometry
{
    import flash.geom.Vector3D;
    import starlogo.engine;

    use namespace engine;

    /**
     * A model's place, rotation and size in the world. The model is scaled by <code>size</code>, rotated, then moved to (x, y, z), all
     * about its origin (thesis §3.5).
     *
     * <p>A point p of the model is at <code>size R p + (x, y, z)</code>. R's rows are (r00 r01 r02), (r10 r11 r12), (r20 r21 r22). The
     * numbers have double precision in every player. A Matrix3D does not, because Flash Player keeps it in single precision. They are read only:
     * <code>setRotation()</code>, <code>setQuaternion()</code> and <code>setMatrix()</code> write them.</p>
     */
    public final class Placement
    {
        /** @private The largest coordinate in the world: Agent.LARGEST_COORDINATE. */
        engine static const LARGEST_COORDINATE:Number = 1e9;

        /** @private The placement of what stays where it is. Not to be changed. */
        engine static const IDENTITY:Placement = new Placement();

        /** The x coordinate of the model's origin in the world, in patches. */
        public var x:Number = 0;

        /** The y coordinate of the model's origin in the world, in patches. */
        public var y:Number = 0;

        /** The z coordinate of the model's origin in the world, in patches. */
        public var z:Number = 0;

        /** The uniform scale, above 0. */
        public var size:Number = 1;

        /** The rotation: row 0, column 0. */
        public var r00:Number = 1;

        /** The rotation: row 0, column 1. */
        public var r01:Number = 0;

        /** The rotation: row 0, column 2. */
        public var r02:Number = 0;

        /** The rotation: row 1, column 0. */
        public var r10:Number = 0;

        /** The rotation: row 1, column 1. */
        public var r11:Number = 1;

        /** The rotation: row 1, column 2. */
        public var r12:Number = 0;

        /** The rotation: row 2, column 0. */
        public var r20:Number = 0;

        /** The rotation: row 2, column 1. */
        public var r21:Number = 0;

        /** The rotation: row 2, column 2. */
        public var r22:Number = 1;

        /** Creates a placement at the world's origin, with size 1 and without rotation. */
        public function Placement()
        {
        }

        /** Copies size, rotation and position of another placement. */
        public function copyFrom(other:Placement):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            size = other.size;
            copyRotation(other);
        }

        /** Copies the rotation of another placement. */
        public function copyRotation(other:Placement):void
        {
            r00 = other.r00;
            r01 = other.r01;
            r02 = other.r02;
            r10 = other.r10;
            r11 = other.r11;
            r12 = other.r12;
            r20 = other.r20;
            r21 = other.r21;
            r22 = other.r22;
        }

        /**
         * Sets the rotation: roll about x, then pitch about y, then heading about z, all about the world's axes.
         * Whole quarter turns are exact.
         *
         * @param heading degrees about z, counter-clockwise seen from above
         * @param pitch degrees about y
         * @param roll degrees about x
         */
        public function setRotation(heading:Number, pitch:Number, roll:Number):void
        {
            var cosHeading:Number = Trigonometry.cosine(heading);
            var sinHeading:Number = Trigonometry.sine(heading);
            if (pitch == 0 && roll == 0)
            {
                r00 = cosHeading;
                // Not -0, so that it is the same as in a placement without rotation.
                r01 = 0 - sinHeading;
                r10 = sinHeading;
                r11 = cosHeading;
                r02 = r12 = r20 = r21 = 0;
                r22 = 1;
                return;
            }
            var cosPitch:Number = Trigonometry.cosine(pitch);
            var sinPitch:Number = Trigonometry.sine(pitch);
            var cosRoll:Number = Trigonometry.cosine(roll);
            var sinRoll:Number = Trigonometry.sine(roll);
            r00 = cosHeading * cosPitch;
            r01 = cosHeading * sinPitch * sinRoll - sinHeading * cosRoll;
            r02 = cosHeading * sinPitch * cosRoll + sinHeading * sinRoll;
            r10 = sinHeading * cosPitch;
            r11 = sinHeading * sinPitch * sinRoll + cosHeading * cosRoll;
            r12 = sinHeading * sinPitch * cosRoll - cosHeading * sinRoll;
            r20 = 0 - sinPitch;
            r21 = cosPitch * sinRoll;
            r22 = cosPitch * cosRoll;
        }

        /** Sets the rotation from a quaternion x i + y j + z k + w of any length up to 1e150. If it is shorter than 1e-150, there is no rotation. */
        public function setQuaternion(x:Number, y:Number, z:Number, w:Number):void
        {
            var squared:Number = x * x + y * y + z * z + w * w;
            var twice:Number = squared > 1e-300 ? 2 / squared : 0;
            r00 = 1 - twice * (y * y + z * z);
            r01 = twice * (x * y - w * z);
            r02 = twice * (x * z + w * y);
            r10 = twice * (x * y + w * z);
            r11 = 1 - twice * (x * x + z * z);
            r12 = twice * (y * z - w * x);
            r20 = twice * (x * z - w * y);
            r21 = twice * (y * z + w * x);
            r22 = 1 - twice * (x * x + y * y);
        }

        /**
         * Finds the angles with which setRotation() makes this rotation. The pitch is between -90 and 90 degrees.
         *
         * @param out receives roll, pitch and heading, in degrees, as x, y and z
         */
        public function readAngles(out:Vector3D):void
        {
            var level:Number = Math.sqrt(r00 * r00 + r10 * r10);
            // Roll comes from the rotation without its heading. So it is right even if the heading is arbitrary.
            var cosHeading:Number = level == 0 ? 1 : r00 / level;
            var sinHeading:Number = level == 0 ? 0 : r10 / level;
            out.x = Trigonometry.arctangent(sinHeading * r02 - cosHeading * r12, cosHeading * r11 - sinHeading * r01);
            out.y = Trigonometry.arctangent(-r20, level);
            out.z = Trigonometry.arctangent(r10, r00);
        }

        /** Whether another placement has the same rotation, to the last bit. */
        public function hasRotationOf(other:Placement):Boolean
        {
            return r00 == other.r00 && r01 == other.r01 && r02 == other.r02
                && r10 == other.r10 && r11 == other.r11 && r12 == other.r12
                && r20 == other.r20 && r21 == other.r21 && r22 == other.r22;
        }

        /**
         * Sets position, rotation and size from a matrix. The rotation is not made orthogonal.
         *
         * @param data column by column, as in a Matrix3D
         * @return whether the matrix only rotates, scales uniformly and moves; if not, the placement means nothing. The position may be any numbers
         */
        public function setMatrix(data:Vector.<Number>):Boolean
        {
            x = data[12];
            y = data[13];
            z = data[14];
            size = Math.sqrt(data[0] * data[0] + data[1] * data[1] + data[2] * data[2]);
            r00 = data[0] / size;
            r10 = data[1] / size;
            r20 = data[2] / size;
            r01 = data[4] / size;
            r11 = data[5] / size;
            r21 = data[6] / size;
            r02 = data[8] / size;
            r12 = data[9] / size;
            r22 = data[10] / size;
            return data[3] == 0 && data[7] == 0 && data[11] == 0 && data[15] == 1 && isRotation;
        }

        /** Whether the nine numbers are a rotation, up to rounding, and not a reflection. */
        public function get isRotation():Boolean
        {
            return isOrthonormal && r02 * (r10 * r21 - r20 * r11) + r12 * (r20 * r01 - r00 * r21) + r22 * (r00 * r11 - r10 * r01) > 0;
        }

        /** @private Whether the three columns are perpendicular unit vectors, within Tolerances.ORTHONORMALITY: a rotation or a reflection. */
        engine function get isOrthonormal():Boolean
        {
            return isNear(r00 * r00 + r10 * r10 + r20 * r20, 1) && isNear(r01 * r01 + r11 * r11 + r21 * r21, 1)
                && isNear(r02 * r02 + r12 * r12 + r22 * r22, 1) && isNear(r00 * r01 + r10 * r11 + r20 * r21, 0)
                && isNear(r00 * r02 + r10 * r12 + r20 * r22, 0) && isNear(r01 * r02 + r11 * r12 + r21 * r22, 0);
        }

        /**
         * Finds the quaternion of the rotation (Shepperd, "Quaternion from Rotation Matrix", 1978: the largest of the four first).
         *
         * @param out receives x, y, z, w; w is not negative
         */
        public function readQuaternion(out:Vector.<Number>):void
        {
            var i:Number = 1 + r00 - r11 - r22;
            var j:Number = 1 - r00 + r11 - r22;
            var k:Number = 1 - r00 - r11 + r22;
            var real:Number = 1 + r00 + r11 + r22;
            if (real >= i && real >= j && real >= k)
            {
                i = r21 - r12;
                j = r02 - r20;
                k = r10 - r01;
            }
            else if (i >= j && i >= k)
            {
                j = r10 + r01;
                k = r02 + r20;
                real = r21 - r12;
            }
            else if (j >= k)
            {
                i = r10 + r01;
                k = r21 + r12;
                real = r02 - r20;
            }
            else
            {
                i = r02 + r20;
                j = r21 + r12;
                real = r10 - r01;
            }
            var scale:Number = 1 / Math.sqrt(i * i + j * j + k * k + real * real);
            if (real < 0)
            {
                scale = -scale;
            }
            out[0] = i * scale;
            out[1] = j * scale;
            out[2] = k * scale;
            out[3] = real * scale;
        }

        /**
         * Reads position, rotation and size into a matrix. It is the counterpart of setMatrix.
         *
         * @param out sixteen numbers, column by column, as in a Matrix3D. Numbers that are the same in all placements are not written
         */
        public function readMatrix(out:Vector.<Number>):void
        {
            out[0] = size * r00;
            out[1] = size * r10;
            out[2] = size * r20;
            out[4] = size * r01;
            out[5] = size * r11;
            out[6] = size * r21;
            out[8] = size * r02;
            out[9] = size * r12;
            out[10] = size * r22;
            out[12] = x;
            out[13] = y;
            out[14] = z;
        }

        /**
         * Transforms a point: scales, rotates and moves it.
         *
         * @param point in the model's space
         * @param out receives the point in the world; may be the point itself
         * @private
         */
        engine function place(point:Vector3D, out:Vector3D):void
        {
            var fromX:Number = point.x * size;
            var fromY:Number = point.y * size;
            var fromZ:Number = point.z * size;
            out.x = r00 * fromX + r01 * fromY + r02 * fromZ + x;
            out.y = r10 * fromX + r11 * fromY + r12 * fromZ + y;
            out.z = r20 * fromX + r21 * fromY + r22 * fromZ + z;
        }

        /**
         * Rotates a vector.
         *
         * @param vector in the model's space
         * @param out receives the result; may be the vector itself
         * @private
         */
        engine function rotate(vector:Vector3D, out:Vector3D):void
        {
            var fromX:Number = vector.x;
            var fromY:Number = vector.y;
            var fromZ:Number = vector.z;
            out.x = r00 * fromX + r01 * fromY + r02 * fromZ;
            out.y = r10 * fromX + r11 * fromY + r12 * fromZ;
            out.z = r20 * fromX + r21 * fromY + r22 * fromZ;
        }

        /** @private Reads the rotation, row by row, into a list from an index on. */
        engine function readRows(out:Vector.<Number>, at:int):void
        {
            out[at] = r00;
            out[int(at + 1)] = r01;
            out[int(at + 2)] = r02;
            out[int(at + 3)] = r10;
            out[int(at + 4)] = r11;
            out[int(at + 5)] = r12;
            out[int(at + 6)] = r20;
            out[int(at + 7)] = r21;
            out[int(at + 8)] = r22;
        }

        /** @private Sets the rotation from nine numbers, row by row, from an index on. It may be a reflection. */
        engine function setRows(from:Vector.<Number>, at:int):void
        {
            r00 = from[at];
            r01 = from[int(at + 1)];
            r02 = from[int(at + 2)];
            r10 = from[int(at + 3)];
            r11 = from[int(at + 4)];
            r12 = from[int(at + 5)];
            r20 = from[int(at + 6)];
            r21 = from[int(at + 7)];
            r22 = from[int(at + 8)];
        }

        // The comparison is false for NaN.
        private static function isNear(a:Number, b:Number):Boolean
        {
            return Math.abs(a - b) <= Tolerances.ORTHONORMALITY;
        }

        // These are static because a page loads such a method only if something calls it.

        /** @private Sets a placement to the inverse of another one: what that one moves into the world, it moves back. */
        engine static function invert(placement:Placement, out:Placement):void
        {
            var scale:Number = 1 / placement.size;
            out.size = scale;
            out.r00 = placement.r00;
            out.r01 = placement.r10;
            out.r02 = placement.r20;
            out.r10 = placement.r01;
            out.r11 = placement.r11;
            out.r12 = placement.r21;
            out.r20 = placement.r02;
            out.r21 = placement.r12;
            out.r22 = placement.r22;
            out.x = -(out.r00 * scale) * placement.x - out.r01 * scale * placement.y - out.r02 * scale * placement.z;
            out.y = -(out.r10 * scale) * placement.x - out.r11 * scale * placement.y - out.r12 * scale * placement.z;
            out.z = -(out.r20 * scale) * placement.x - out.r21 * scale * placement.y - out.r22 * scale * placement.z;
        }

        /** @private Rotates a vector by the inverse of a placement's rotation. The result may be written to the vector itself. */
        engine static function rotateBack(placement:Placement, vector:Vector3D, out:Vector3D):void
        {
            var fromX:Number = vector.x;
            var fromY:Number = vector.y;
            var fromZ:Number = vector.z;
            out.x = placement.r00 * fromX + placement.r10 * fromY + placement.r20 * fromZ;
            out.y = placement.r01 * fromX + placement.r11 * fromY + placement.r21 * fromZ;
            out.z = placement.r02 * fromX + placement.r12 * fromY + placement.r22 * fromZ;
        }

        /** @private Sets the rotation of a placement to that of b as seen from a: the inverse of a's rotation times b's. */
        engine static function setRelativeRotation(a:Placement, b:Placement, out:Placement):void
        {
            out.r00 = a.r00 * b.r00 + a.r10 * b.r10 + a.r20 * b.r20;
            out.r01 = a.r00 * b.r01 + a.r10 * b.r11 + a.r20 * b.r21;
            out.r02 = a.r00 * b.r02 + a.r10 * b.r12 + a.r20 * b.r22;
            out.r10 = a.r01 * b.r00 + a.r11 * b.r10 + a.r21 * b.r20;
            out.r11 = a.r01 * b.r01 + a.r11 * b.r11 + a.r21 * b.r21;
            out.r12 = a.r01 * b.r02 + a.r11 * b.r12 + a.r21 * b.r22;
            out.r20 = a.r02 * b.r00 + a.r12 * b.r10 + a.r22 * b.r20;
            out.r21 = a.r02 * b.r01 + a.r12 * b.r11 + a.r22 * b.r21;
            out.r22 = a.r02 * b.r02 + a.r12 * b.r12 + a.r22 * b.r22;
        }
    }
}
