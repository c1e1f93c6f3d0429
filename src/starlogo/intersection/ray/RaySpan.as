package starlogo.intersection.ray
{
    /**
     * The part of a ray's line that is inside of a convex shape, as a record. SpanFinder finds it. All places are distances, as the ray counts
     * them. They may be before the ray begins or after it ends.
     *
     * @private
     */
    public final class RaySpan
    {
        /** Where the line first and last touches the shape. Touching counts, so these may be a rounding error beside the shape. */
        public var near:Number = 0;
        public var far:Number = 0;

        /** Where the line enters and leaves the shape itself, from near to far. If the line only touches it, they may be the same as near and far. */
        public var entrance:Number = 0;
        public var exit:Number = 0;

        /** The direction of the surface's normal where the line enters, inwards or outwards. It has any length, and 0 if the shape has no surface. */
        public var nearX:Number = 0;
        public var nearY:Number = 0;
        public var nearZ:Number = 0;

        /** The same where the line leaves the shape. */
        public var farX:Number = 0;
        public var farY:Number = 0;
        public var farZ:Number = 0;

        /** Copies where another shape is entered. */
        public function copyNear(other:RaySpan):void
        {
            near = other.near;
            entrance = other.entrance;
            nearX = other.nearX;
            nearY = other.nearY;
            nearZ = other.nearZ;
        }

        /** Copies where another shape is left. */
        public function copyFar(other:RaySpan):void
        {
            far = other.far;
            exit = other.exit;
            farX = other.farX;
            farY = other.farY;
            farZ = other.farZ;
        }

        /** Sets the ends, for a shape whose touched surface is its own. */
        public function setEnds(near:Number, far:Number):void
        {
            this.near = entrance = near;
            this.far = exit = far;
        }

        /** Sets the direction of the normal where the line enters. */
        public function setNormalNear(x:Number, y:Number, z:Number):void
        {
            nearX = x;
            nearY = y;
            nearZ = z;
        }

        /** Sets the direction of the normal where the line leaves. */
        public function setNormalFar(x:Number, y:Number, z:Number):void
        {
            farX = x;
            farY = y;
            farZ = z;
        }
    }
}
