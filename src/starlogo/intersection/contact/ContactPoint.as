package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;

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

        /** How long the vector was that the normal was made of. */
        public var length:Number = 1;

        /** How far the first structure reaches from its core, for <code>place()</code>. */
        public var radius:Number = 0;

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
         * Makes it the contact of the same structures in the other order: then the other structure is displaced, and in the opposite direction.
         *
         * @param motion of that structure, which is where it is at the motion's time
         */
        public function turn(motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            x += motion.startX + time * motion.x;
            y += motion.startY + time * motion.y;
            z += motion.startZ + time * motion.z;
            normalX = -normalX;
            normalY = -normalY;
            normalZ = -normalZ;
        }

        /** Sets the normal to a vector, which is not made a unit vector. Short, so that V8 makes no objects of the Numbers. */
        public function setNormal(x:Number, y:Number, z:Number):void
        {
            normalX = x;
            normalY = y;
            normalZ = z;
        }

        /** Makes the normal, of any length but 0, a unit vector; <code>length</code> is how long it was. */
        public function normalise():void
        {
            length = Math.sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ);
            normalX /= length;
            normalY /= length;
            normalZ /= length;
        }

        /** How far a vector goes along the normal. */
        public function along(vector:Vector3D):Number
        {
            return normalX * vector.x + normalY * vector.y + normalZ * vector.z;
        }

        /** Moves a place along the normal. */
        public function push(place:Vector3D, by:Number):void
        {
            place.x += by * normalX;
            place.y += by * normalY;
            place.z += by * normalZ;
        }

        /** Sets the normal to the opposite of a motion's direction. */
        public function pointAgainst(motion:RelativeMotion):void
        {
            setNormal(-motion.x, -motion.y, -motion.z);
            normalise();
        }

        /** Turns the normal to be at right angles to what it is: as upright as can be; where it is upright, or has no length, along x or z. */
        public function pointAcross():void
        {
            var axisX:Number = normalX;
            var axisY:Number = normalY;
            var axisZ:Number = normalZ;
            var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            if (!(squared > 0))
            {
                setNormal(0, 0, 1);
                return;
            }
            if (axisX * axisX + axisY * axisY > Tolerances.UPRIGHT * squared)
            {
                setNormal(-axisX * axisZ / squared, -axisY * axisZ / squared, 1 - axisZ * axisZ / squared);
            }
            else
            {
                setNormal(1 - axisX * axisX / squared, -axisX * axisY / squared, -axisX * axisZ / squared);
            }
            normalise();
        }

        /**
         * Moves the point, one of the first structure's core that the normal points away from, to the middle of the overlap. Normal, depth and radius
         * are there; a depth that is below 0 by rounding becomes 0.
         */
        public function place():void
        {
            depth = depth > 0 ? depth : 0;
            var back:Number = radius - depth / 2;
            x -= back * normalX;
            y -= back * normalY;
            z -= back * normalZ;
        }
    }
}
