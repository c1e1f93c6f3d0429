package starlogo.convex
{
    /** A direction, and how far two cores are apart along it, as a record. The shapes' radii do not count. */
    internal final class SeparatingAxis
    {
        /** A unit vector from the second core to the first. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 1;

        /** How far the cores are apart along it: at most their distance. It is less than 0 if they overlap along the vector. */
        public var separation:Number = 0;

        /** Sets the unit vector and the separation. */
        public function setTo(x:Number, y:Number, z:Number, separation:Number):void
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.separation = separation;
        }
    }
}
