package starlogo.search.penetration
{
    /** A displacement, as a record: a direction of the length 1, and how far along it, in patches. */
    internal final class Displacement
    {
        public var directionX:Number = 0;
        public var directionY:Number = 0;
        public var directionZ:Number = 0;
        public var distance:Number = 0;

        /** Sets the direction. The function is short so that V8 inlines it and allocates no objects for the Numbers. */
        public function setDirection(x:Number, y:Number, z:Number):void
        {
            directionX = x;
            directionY = y;
            directionZ = z;
        }
    }
}
