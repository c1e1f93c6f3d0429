package starlogo.intersection.boxes
{
    /**
     * The projections of two moving shapes on an axis, as a record. The axis may have any length.
     *
     * @private
     */
    public final class AxisMotion
    {
        /** The place of the second shape's middle at time 0, seen from the first one's. */
        public var offset:Number = 0;

        /** How far the second shape moves until time 1. */
        public var speed:Number = 0;

        /** The half-extents of both shapes along the axis, added. */
        public var halfExtents:Number = 0;

        /** The gap across which the shapes still touch. */
        public var margin:Number = 0;
    }
}
