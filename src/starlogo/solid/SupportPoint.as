package starlogo.solid
{
    /**
     * The farthest point of a model in a direction, and how far it is. A record.
     *
     * @private
     */
    public final class SupportPoint
    {
        /** The coordinate of the point along the direction, in patches. */
        public var support:Number = 0;

        /** The point in the world, or one for several that are as far. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Becomes the same as another point. */
        public function copyFrom(other:SupportPoint):void
        {
            support = other.support;
            x = other.x;
            y = other.y;
            z = other.z;
        }
    }
}
