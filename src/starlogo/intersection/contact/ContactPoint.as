package starlogo.intersection.contact
{
    import starlogo.geometry.Tolerances;

    /**
     * Where two structures touch, or how they overlap: the point, the normal, and how deep. Plain fields, for reuse.
     *
     * @private
     */
    public final class ContactPoint
    {
        /** In the middle of the overlap, in the structures' space. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** The direction in which the first would have to be moved to get free, a unit vector. */
        public var normalX:Number = 0;

        /** @copy #normalX */
        public var normalY:Number = 0;

        /** @copy #normalX */
        public var normalZ:Number = 1;

        /** How far, not negative: 0 if they just touch. */
        public var depth:Number = 0;

        /** At the origin, upright. */
        public function ContactPoint()
        {
        }

        /** Takes over all of another. */
        public function copyFrom(other:ContactPoint):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            normalX = other.normalX;
            normalY = other.normalY;
            normalZ = other.normalZ;
            depth = other.depth;
        }

        /**
         * Makes it the contact of the same structures in the other order: then the other structure is displaced, by the opposite vector.
         *
         * @param x that vector
         * @param y likewise
         * @param z likewise
         */
        public function turn(x:Number, y:Number, z:Number):void
        {
            this.x += x;
            this.y += y;
            this.z += z;
            normalX = -normalX;
            normalY = -normalY;
            normalZ = -normalZ;
        }

        /** Sets the normal to a vector, of any length but 0; returns the length. */
        public function pointAlong(x:Number, y:Number, z:Number):Number
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            normalX = x / length;
            normalY = y / length;
            normalZ = z / length;
            return length;
        }

        /** Sets the normal at right angles to an axis: as upright as can be; where the axis is upright, or has no length, along x or z. */
        public function pointAcross(x:Number, y:Number, z:Number):void
        {
            var squared:Number = x * x + y * y + z * z;
            if (!(squared > 0))
            {
                pointAlong(0, 0, 1);
                return;
            }
            if (x * x + y * y > Tolerances.UPRIGHT * squared)
            {
                pointAlong(-x * z / squared, -y * z / squared, 1 - z * z / squared);
                return;
            }
            pointAlong(1 - x * x / squared, -x * y / squared, -x * z / squared);
        }

        /**
         * Sets point and depth; the normal is there.
         *
         * @param x a point of the first structure's core, which the normal points away from
         * @param y likewise
         * @param z likewise
         * @param radius how far the structure reaches from its core
         * @param depth how deep; what is below 0 by rounding is 0
         */
        public function place(x:Number, y:Number, z:Number, radius:Number, depth:Number):void
        {
            this.depth = depth > 0 ? depth : 0;
            var back:Number = radius - this.depth / 2;
            this.x = x - back * normalX;
            this.y = y - back * normalY;
            this.z = z - back * normalZ;
        }
    }
}
