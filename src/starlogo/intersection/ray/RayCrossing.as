package starlogo.intersection.ray
{
    import flash.geom.Vector3D;

    /**
     * A place where a ray enters a shape or crosses its surface, as a record. A ray that begins inside of the shape enters it where it begins.
     *
     * @private
     */
    public final class RayCrossing
    {
        /** A side: the ray begins inside of the shape. */
        public static const INSIDE:int = 2;

        /** A side: the ray enters the shape, or crosses a triangle from the side from which its corners are counter-clockwise. */
        public static const ENTERS:int = 1;

        /** A side: the ray leaves the shape, or crosses a triangle from the other side. */
        public static const LEAVES:int = -1;

        /** A side: the ray runs along a triangle, from its distance to its end. */
        public static const EDGE_ON:int = 0;

        /** The distance of the place, as the ray counts distances. */
        public var distance:Number = 0;

        /** The unit normal of the surface there, against the ray. If the ray begins inside, it is the opposite of the ray's direction. */
        public var normal:Vector3D = new Vector3D();

        /** The number of the triangle there, as the model counts them. It is -1 if no triangle decides, or if the ray begins inside. */
        public var triangle:int = -1;

        /** INSIDE, ENTERS, LEAVES or, at a triangle only, EDGE_ON. A ray's first entry has no side, rounding and end. */
        public var side:int = 0;

        /** How far the distance may be wrong because of rounding. */
        public var rounding:Number = 0;

        /** Where the ray leaves a triangle that it runs along. For others it need not be set. */
        public var end:Number = 0;

        /** Sets it to where a ray begins. */
        public function setToStart(ray:Ray):void
        {
            distance = ray.from;
            setNormalAgainst(ray);
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
                setNormal(ray, near.normal);
            }
            return distance <= span.far.touchDistance && distance <= ray.to;
        }

        /**
         * Sets it to where a ray leaves a convex shape.
         *
         * @param span the part of the ray's line inside of the shape
         * @param entry where the ray enters the shape
         * @return whether the ray leaves it, and does not end inside
         */
        public function setToExit(ray:Ray, span:RaySpan, entry:RayCrossing):Boolean
        {
            distance = Math.max(entry.distance, span.far.surfaceDistance);
            triangle = -1;
            setNormal(ray, span.far.normal);
            return distance <= ray.to;
        }

        /**
         * Sets the normal to the direction of a vector, or to the opposite one if the vector points along the ray. If the vector's length is 0, the normal
         * is the opposite of the ray's direction.
         */
        public function setNormal(ray:Ray, vector:Vector3D):void
        {
            var direction:Vector3D = ray.direction;
            var length:Number = Math.sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
            if (!(length > 0))
            {
                setNormalAgainst(ray);
                return;
            }
            length = vector.x * direction.x + vector.y * direction.y + vector.z * direction.z > 0 ? -length : length;
            normal.setTo(vector.x / length, vector.y / length, vector.z / length);
        }

        private function setNormalAgainst(ray:Ray):void
        {
            normal.setTo(-ray.direction.x, -ray.direction.y, -ray.direction.z);
        }
    }
}
