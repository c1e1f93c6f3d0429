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
        public function setToStart(ray:Ray):void
        {
            distance = ray.from;
            normalX = -ray.directionX;
            normalY = -ray.directionY;
            normalZ = -ray.directionZ;
            triangle = -1;
        }

        /**
         * Sets it to where a ray enters a convex shape.
         *
         * @param span the part of the ray's line inside of the shape
         * @return whether the ray enters it, and does not begin beyond it or end before it
         */
        public function setToEntry(ray:Ray, span:RaySpan):Boolean
        {
            setToStart(ray);
            var near:SpanEnd = span.near;
            if (near.touchDistance > ray.from)
            {
                distance = near.surfaceDistance <= ray.to ? near.surfaceDistance : near.touchDistance;
                setNormal(ray, near.normalX, near.normalY, near.normalZ);
            }
            return distance <= span.far.touchDistance && distance <= ray.to;
        }

        /**
         * Goes on from where a ray enters a convex shape to where it leaves it.
         *
         * @param span the part of the ray's line inside of the shape
         * @return whether the ray leaves it, and does not end inside
         */
        public function setToExit(ray:Ray, span:RaySpan):Boolean
        {
            distance = Math.max(distance, span.far.surfaceDistance);
            setNormal(ray, span.far.normalX, span.far.normalY, span.far.normalZ);
            return distance <= ray.to;
        }

        /** Sets the normal to the direction of a vector, or to the opposite one if the vector points along the ray. If its length is 0, the normal stays. */
        public function setNormal(ray:Ray, x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length > 0)
            {
                length = x * ray.directionX + y * ray.directionY + z * ray.directionZ > 0 ? -length : length;
                normalX = x / length;
                normalY = y / length;
                normalZ = z / length;
            }
        }
    }
}
