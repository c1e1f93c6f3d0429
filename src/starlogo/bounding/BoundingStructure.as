package starlogo.bounding
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A simple solid that encloses a model: what the collision systems test in its place (thesis §3.3).
     *
     * <p>Every structure is a closed set: its surface belongs to it. Two structures that merely touch collide, here and
     * everywhere in the engine.</p>
     *
     * <p>A structure lives either in the space of its model or, once placed, in the world; lengths are in patches.
     * Scaling, rotating and translating are about the origin of that space, change the structure in place and return
     * it, so that calls can be chained; <code>clone()</code> first to keep the original. A call that throws changes
     * nothing. The subclasses are Sphere, Capsule, Box and Cylinder. The pair tests know these only.</p>
     */
    public class BoundingStructure
    {
        /** The kind of a Sphere. */
        public static const SPHERE:int = 0;

        /** The kind of a Capsule. */
        public static const CAPSULE:int = 1;

        /** The kind of a Box. */
        public static const BOX:int = 2;

        /** The kind of a Cylinder. */
        public static const CYLINDER:int = 3;

        private static var sMatrix:Vector.<Number> = new Vector.<Number>(16, true);

        /** Which structure this is: SPHERE, CAPSULE, BOX or CYLINDER. To be read only. */
        public var kind:int;

        /**
         * For subclasses only.
         *
         * @param kind one of the constants
         */
        public function BoundingStructure(kind:int)
        {
            this.kind = kind;
        }

        /** What it is, and where, for messages. */
        public function toString():String
        {
            return "a structure of kind " + kind;
        }

        /** The volume in cubic patches; 0 for a structure that is flat, a line or a point. */
        public function get volume():Number
        {
            throw missing("volume");
        }

        /**
         * Scales the structure about the origin, uniformly.
         *
         * @param factor positive and finite
         * @return this structure
         * @throws RangeError when the factor is not positive and finite
         */
        public function scale(factor:Number):BoundingStructure
        {
            throw missing("scale");
        }

        /**
         * Rotates the structure about the origin. In single precision, which is what Flash Player's Matrix3D has, the
         * result is as precise as the matrix. A box's axes stay unit vectors at right angles in double precision.
         *
         * @param rotation a rotation and nothing else; a reflection passes too, structures being symmetric
         * @return this structure
         * @throws ArgumentError when the matrix is null, scales, shears, projects or translates
         */
        public function rotate(rotation:Matrix3D):BoundingStructure
        {
            throw missing("rotate");
        }

        /**
         * Moves the structure.
         *
         * @param offset in patches
         * @return this structure
         * @throws ArgumentError when the offset is null
         * @throws RangeError when a component is not finite
         */
        public function translate(offset:Vector3D):BoundingStructure
        {
            throw missing("translate");
        }

        /**
         * Whether a point is inside of the structure or on its surface. Points outside by no more than
         * Tolerances.CONTAINMENT of the structure's size count as inside: rounding never excludes what a fit enclosed.
         *
         * @param point in the structure's space
         */
        public function contains(point:Vector3D):Boolean
        {
            throw missing("contains");
        }

        /** A copy that shares nothing with this structure. */
        public function clone():BoundingStructure
        {
            throw missing("clone");
        }

        /**
         * This structure put through an agent's whole transform: scaled, rotated, translated (thesis §3.5). In double
         * precision throughout. Allocates nothing when <code>out</code> is given.
         *
         * @param placement where the model stands; its numbers are not checked
         * @param out a structure of the same kind that takes the result; may be this structure itself
         * @return out, or a new structure
         * @throws ArgumentError when out is of another kind
         */
        public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            throw missing("place");
        }

        /** A structure for the result of <code>place</code> where out is not of its kind: a new one for null, or an error. */
        protected final function newFor(out:BoundingStructure):BoundingStructure
        {
            if (out != null)
            {
                throw new ArgumentError("out must be of the kind of " + this + ", or null: " + out);
            }
            return clone();
        }

        /**
         * Makes the structure wider on all sides: by the margin of touching at its place.
         *
         * @param by a length, not negative
         *
         * @private
         */
        engine function widen(by:Number):void
        {
            throw missing("widen");
        }

        /**
         * Writes the extents along the axes of the structure's space: minX, maxX, minY, maxY, minZ, maxZ. They are the
         * tightest, widened by a rounding error (Tolerances.ROUNDING), so that the extents of structures that touch
         * always overlap or touch. Allocates nothing.
         *
         * @param out takes six numbers
         * @param offset the index of the first
         */
        public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            throw missing("extentsInto");
        }

        /**
         * Writes the extents that this structure has where a placement puts it, without putting it there: the middle, as seen
         * from the placement's position, and half the lengths. They stay while an agent only moves. Allocates nothing.
         *
         * @param placement where the model stands; its position does not count
         * @param out takes six numbers: x, y, z of the middle, half the lengths along x, y, z, widened like extentsInto's
         *     but for the rounding of the position
         *
         * @private
         */
        engine function turnedExtentsInto(placement:Placement, out:Vector.<Number>):void
        {
            throw missing("turnedExtentsInto");
        }

        /**
         * Checks a vector.
         *
         * @param vector what was given
         * @param what its name, for the message
         * @return the vector
         * @throws ArgumentError when it is null
         * @throws RangeError when a component is not finite
         */
        protected static function checkVector(vector:Vector3D, what:String):Vector3D
        {
            if (vector == null)
            {
                throw new ArgumentError(what + " must not be null");
            }
            if (!isFinite(vector.x) || !isFinite(vector.y) || !isFinite(vector.z))
            {
                throw new RangeError(what + " must be finite: " + vector);
            }
            return vector;
        }

        /**
         * Checks a radius or half-extent.
         *
         * @param length what was given
         * @param what its name, for the message
         * @return the length
         * @throws RangeError when it is negative or not finite
         */
        protected static function checkLength(length:Number, what:String):Number
        {
            if (!(length >= 0 && length < Infinity))
            {
                throw new RangeError(what + " must be finite and not negative: " + length);
            }
            return length;
        }

        /**
         * Checks a scale factor.
         *
         * @param factor what was given
         * @return the factor
         * @throws RangeError when it is not positive and finite
         */
        protected static function checkFactor(factor:Number):Number
        {
            if (!(factor > 0 && factor < Infinity))
            {
                throw new RangeError("a scale factor must be positive and finite: " + factor);
            }
            return factor;
        }

        /**
         * Checks a matrix and reads it.
         *
         * @param rotation what was given
         * @return its sixteen numbers, column by column, in a vector that the next call overwrites
         * @throws ArgumentError when it is null or no rotation
         */
        protected static function readRotation(rotation:Matrix3D):Vector.<Number>
        {
            if (rotation == null)
            {
                throw new ArgumentError("the rotation must not be null");
            }
            var m:Vector.<Number> = sMatrix;
            rotation.copyRawDataTo(m);
            var isAffine:Boolean = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
            var isCentred:Boolean = m[12] == 0 && m[13] == 0 && m[14] == 0;
            if (!isAffine || !isCentred || !isOrthonormal(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]))
            {
                throw new ArgumentError("a rotation must rotate about the origin and do nothing else: " + rotation.rawData);
            }
            return m;
        }

        /** Whether three vectors are of unit length and at right angles, within Tolerances.ORTHONORMALITY. */
        protected static function isOrthonormal(xx:Number, xy:Number, xz:Number, yx:Number, yy:Number, yz:Number,
                zx:Number, zy:Number, zz:Number):Boolean
        {
            var areUnit:Boolean = isNear(xx * xx + xy * xy + xz * xz, 1) && isNear(yx * yx + yy * yy + yz * yz, 1)
                && isNear(zx * zx + zy * zy + zz * zz, 1);
            return areUnit && isNear(xx * yx + xy * yy + xz * yz, 0) && isNear(xx * zx + xy * zy + xz * zz, 0)
                && isNear(yx * zx + yy * zy + yz * zz, 0);
        }

        /** Rotates a vector in place, by a matrix as readRotation gives it. */
        protected static function turn(vector:Vector3D, m:Vector.<Number>):void
        {
            var x:Number = vector.x;
            var y:Number = vector.y;
            var z:Number = vector.z;
            vector.x = m[0] * x + m[4] * y + m[8] * z;
            vector.y = m[1] * x + m[5] * y + m[9] * z;
            vector.z = m[2] * x + m[6] * y + m[10] * z;
        }

        /**
         * Puts a point through a placement.
         *
         * @param point in the model's space
         * @param placement where the model stands
         * @param out takes the point in the world; may be the point itself
         */
        protected static function placePoint(point:Vector3D, placement:Placement, out:Vector3D):void
        {
            var size:Number = placement.size;
            var x:Number = point.x * size;
            var y:Number = point.y * size;
            var z:Number = point.z * size;
            if (placement.isIdentity)
            {
                out.x = x + placement.x;
                out.y = y + placement.y;
                out.z = z + placement.z;
                return;
            }
            out.x = placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x;
            out.y = placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y;
            out.z = placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z;
        }

        /** Turns a vector by the rotation of a placement. The result goes into out, which may be the vector itself. */
        protected static function turnInto(vector:Vector3D, placement:Placement, out:Vector3D):void
        {
            var x:Number = vector.x;
            var y:Number = vector.y;
            var z:Number = vector.z;
            out.x = placement.r00 * x + placement.r01 * y + placement.r02 * z;
            out.y = placement.r10 * x + placement.r11 * y + placement.r12 * z;
            out.z = placement.r20 * x + placement.r21 * y + placement.r22 * z;
        }

        /**
         * How far outside a point may be and still be contained.
         *
         * @param size the largest extent from the middle
         * @param at a point of the structure
         */
        protected static function slack(size:Number, at:Vector3D):Number
        {
            return Tolerances.CONTAINMENT * size + rounding(size, at);
        }

        /**
         * The rounding error of a position.
         *
         * @param size the largest extent from the middle
         * @param at a point of the structure
         */
        protected static function rounding(size:Number, at:Vector3D):Number
        {
            return Tolerances.ROUNDING * (size + Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z));
        }

        /** Writes one of the extents: that between two coordinates, in either order, wider by a length on both sides. */
        protected static function writeExtent(from:Number, to:Number, reach:Number, out:Vector.<Number>, offset:int):void
        {
            out[offset] = Math.min(from, to) - reach;
            out[int(offset + 1)] = Math.max(from, to) + reach;
        }

        private static function isNear(value:Number, expected:Number):Boolean
        {
            var difference:Number = value - expected;
            return difference <= Tolerances.ORTHONORMALITY && difference >= -Tolerances.ORTHONORMALITY;
        }

        private function missing(method:String):Error
        {
            return new IllegalOperationError(this + " does not implement " + method);
        }
    }
}
