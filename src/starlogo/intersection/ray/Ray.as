package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;

    /**
     * A part of a line, which is asked about. The tests of a ray do not change it. They write where it is inside of a shape to a RaySpan, and where it
     * enters the shape to a RayCrossing.
     *
     * <p>A place on the line is given by its distance along the direction from the point (x, y, z). The direction has length 1.
     * That point should be near the shapes that are asked about, because the rounding error grows with their distance from it. The part may
     * begin far from that point.</p>
     *
     * @private
     */
    public final class Ray
    {
        // The square of a direction's length must be neither infinite nor 0. So a direction that is longer than this, or shorter than 1 divided
        // by this, is scaled.
        private static const LARGE:Number = 1e120;

        /** A point of the line. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The line's direction, of length 1. */
        public var directionX:Number = 0;
        public var directionY:Number = 0;
        public var directionZ:Number = 0;

        /** Where the part begins. */
        public var from:Number = 0;

        /** Where the part ends. */
        public var to:Number = Infinity;

        /**
         * Takes back a placement's size and rotation. Its position is ignored: the line's point must be relative to it already. The part has to be
         * set after that.
         */
        public function scaleAndRotateBack(placement:Placement):void
        {
            var toX:Number = x / placement.size;
            var toY:Number = y / placement.size;
            var toZ:Number = z / placement.size;
            x = placement.r00 * toX + placement.r10 * toY + placement.r20 * toZ;
            y = placement.r01 * toX + placement.r11 * toY + placement.r21 * toZ;
            z = placement.r02 * toX + placement.r12 * toY + placement.r22 * toZ;
            toX = directionX;
            toY = directionY;
            toZ = directionZ;
            directionX = placement.r00 * toX + placement.r10 * toY + placement.r20 * toZ;
            directionY = placement.r01 * toX + placement.r11 * toY + placement.r21 * toZ;
            directionZ = placement.r02 * toX + placement.r12 * toY + placement.r22 * toZ;
        }

        /** Copies the line and the part of another ray. */
        public function copyFrom(other:Ray):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            directionX = other.directionX;
            directionY = other.directionY;
            directionZ = other.directionZ;
            from = other.from;
            to = other.to;
        }

        /** Whether the products of the line's numbers are finite. */
        public function get isFinite():Boolean
        {
            return x * x + y * y + z * z < Infinity;
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
            directionX = toX / length;
            directionY = toY / length;
            directionZ = toZ / length;
            x = origin.x;
            y = origin.y;
            z = origin.z;
            from = 0;
            to = Infinity;
        }
    }
}
