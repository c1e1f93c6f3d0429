package starlogo.intersection.ray
{
    /**
     * Where a ray enters a shape, as a record. A ray that begins inside of the shape enters it where it begins.
     *
     * @private
     */
    public final class RayEntry
    {
        /** The distance of the place, as the ray counts distances. */
        public var distance:Number = 0;

        /** The unit normal of the surface there, against the ray. If the ray begins inside, it is the opposite of the ray's direction. */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 0;

        /** The number of the triangle there, as the model counts them. It is -1 if no triangle decides, or if the ray begins inside. */
        public var triangle:int = -1;

        /** Sets it to where a ray begins. */
        public function begin(ray:Ray):void
        {
            distance = ray.from;
            normalX = -ray.directionX;
            normalY = -ray.directionY;
            normalZ = -ray.directionZ;
            triangle = -1;
        }

        /** Sets the normal to the direction of a vector, which points out of the shape. If its length is 0, the normal stays. */
        public function setOutwards(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length > 0)
            {
                normalX = x / length;
                normalY = y / length;
                normalZ = z / length;
            }
        }

        /** Sets the normal to a unit vector, or to its opposite if the vector points along the ray. */
        public function setNormal(ray:Ray, x:Number, y:Number, z:Number):void
        {
            var side:int = x * ray.directionX + y * ray.directionY + z * ray.directionZ > 0 ? -1 : 1;
            normalX = side * x;
            normalY = side * y;
            normalZ = side * z;
        }
    }
}
