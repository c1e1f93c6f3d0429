package starlogo.geometry
{
    /**
     * Where a model stands in the world: scaled by <code>size</code>, rotated, then moved to (x, y, z), all about the
     * model's origin (thesis §3.5).
     *
     * <p>The numbers are doubles on every player, which a Matrix3D's are not: Flash Player keeps those in single
     * precision. A point p of the model is at <code>size R p + (x, y, z)</code>, R's rows being
     * (r00 r01 r02), (r10 r11 r12), (r20 r21 r22).</p>
     */
    public final class Placement
    {
        /** The x coordinate of the model's origin in the world, in patches. */
        public var x:Number = 0;

        /** Its y coordinate. */
        public var y:Number = 0;

        /** Its z coordinate. */
        public var z:Number = 0;

        /** The uniform scale, positive. */
        public var size:Number = 1;

        /** Counts the changes of all but the position, for caches of what does not depend on it. */
        public var extentsRevision:int = 0;

        /** The turn about z that the rotation is made of, in degrees; see setRotation. */
        public var heading:Number = 0;

        /** The turn about y. */
        public var pitch:Number = 0;

        /** The turn about x. */
        public var roll:Number = 0;

        /** Whether the rotation is the identity. */
        public var isIdentity:Boolean = true;

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

        /** A model that stands at the world's origin, unscaled and not rotated. */
        public function Placement()
        {
        }

        /** Takes over size, rotation and position of another. */
        public function copyFrom(other:Placement):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            size = other.size;
            heading = other.heading;
            pitch = other.pitch;
            roll = other.roll;
            isIdentity = other.isIdentity;
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
            this.heading = heading;
            this.pitch = pitch;
            this.roll = roll;
            isIdentity = heading == 0 && pitch == 0 && roll == 0;
            var cosHeading:Number = cosine(heading);
            var sinHeading:Number = sine(heading);
            if (pitch == 0 && roll == 0)
            {
                r00 = cosHeading;
                r01 = -sinHeading;
                r10 = sinHeading;
                r11 = cosHeading;
                r02 = r12 = r20 = r21 = 0;
                r22 = 1;
                return;
            }
            var cosPitch:Number = cosine(pitch);
            var sinPitch:Number = sine(pitch);
            var cosRoll:Number = cosine(roll);
            var sinRoll:Number = sine(roll);
            r00 = cosHeading * cosPitch;
            r01 = cosHeading * sinPitch * sinRoll - sinHeading * cosRoll;
            r02 = cosHeading * sinPitch * cosRoll + sinHeading * sinRoll;
            r10 = sinHeading * cosPitch;
            r11 = sinHeading * sinPitch * sinRoll + cosHeading * cosRoll;
            r12 = sinHeading * sinPitch * cosRoll - cosHeading * sinRoll;
            r20 = -sinPitch;
            r21 = cosPitch * sinRoll;
            r22 = cosPitch * cosRoll;
        }

        // The remainder first: it keeps large angles as precise as small ones, and makes quarter turns exact.
        private static function sine(degrees:Number):Number
        {
            var angle:Number = degrees % 360;
            if (angle % 180 == 0)
            {
                return 0;
            }
            if (angle % 90 == 0)
            {
                return angle == 90 || angle == -270 ? 1 : -1;
            }
            return Math.sin(angle * (Math.PI / 180));
        }

        private static function cosine(degrees:Number):Number
        {
            var angle:Number = degrees % 360;
            if (angle % 90 == 0)
            {
                return angle == 0 ? 1 : (angle == 180 || angle == -180 ? -1 : 0);
            }
            return Math.cos(angle * (Math.PI / 180));
        }
    }
}
