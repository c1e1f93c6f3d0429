package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A part of a line, which is asked about. The tests of a ray do not change it. They write where it is inside of a shape to a RaySpan, and where it
     * enters the shape to a RayCrossing.
     *
     * <p>A place on the line is given by its distance from the origin along the direction. The origin should be near the shapes that are asked about,
     * because the rounding error grows with their distance from it. The part may begin far from the origin.</p>
     *
     * @private
     */
    public final class Ray
    {
        // The square of a direction's length must be neither infinite nor 0. So a direction that is longer than this, or shorter than 1 divided
        // by this, is scaled.
        private static const LARGE:Number = 1e120;

        /** A point of the line. */
        public var origin:Vector3D = new Vector3D();

        /** The line's direction, of length 1. */
        public var direction:Vector3D = new Vector3D();

        /** Where the part begins. */
        public var from:Number = 0;

        /** Where the part ends. */
        public var to:Number = Infinity;

        /** Takes back a placement's size and rotation. Its position is ignored: the origin must be relative to it already. The part has to be set after that. */
        public function scaleAndRotateBack(placement:Placement):void
        {
            origin.x /= placement.size;
            origin.y /= placement.size;
            origin.z /= placement.size;
            Placement.rotateBack(placement, origin, origin);
            Placement.rotateBack(placement, direction, direction);
        }

        /** Copies the line and the part of another ray. */
        public function copyFrom(other:Ray):void
        {
            origin.copyFrom(other.origin);
            direction.copyFrom(other.direction);
            from = other.from;
            to = other.to;
        }

        /** Whether the products of the line's numbers are finite. */
        public function get isFinite():Boolean
        {
            return origin.x * origin.x + origin.y * origin.y + origin.z * origin.z < Infinity;
        }

        /**
         * Sets the ray to begin at a point in a direction of any length.
         *
         * @throws ArgumentError if one of them is null, or if the direction is 0 or not finite
         */
        public function aim(origin:Vector3D, direction:Vector3D):void
        {
            if (origin == null || direction == null)
            {
                throw new ArgumentError("a ray needs an origin and a direction, not " + origin + " and " + direction);
            }
            var largest:Number = Math.max(Math.abs(direction.x), Math.abs(direction.y));
            largest = Math.max(largest, Math.abs(direction.z));
            if (!(largest > 0 && largest < Infinity))
            {
                throw new ArgumentError("a ray needs a direction, finite and not 0: " + direction);
            }
            var unit:Number = largest > LARGE || largest < 1 / LARGE ? largest : 1;
            var toX:Number = direction.x / unit;
            var toY:Number = direction.y / unit;
            var toZ:Number = direction.z / unit;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            this.direction.setTo(toX / length, toY / length, toZ / length);
            this.origin.copyFrom(origin);
            from = 0;
            to = Infinity;
        }
    }
}
