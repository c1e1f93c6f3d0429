package starlogo.intersection.sweep
{
    /**
     * The projections of two moving shapes on an axis, as a record. The axis may have any length.
     *
     * @private
     */
    public final class AxisMotion
    {
        /** The place of one middle at time 0, as seen from the other middle. */
        public var at:Number = 0;

        /** How far that middle moves along the axis until time 1. */
        public var speed:Number = 0;

        /** The sum of how far both shapes extend along the axis. */
        public var radius:Number = 0;

        /** The gap across which the shapes still touch. */
        public var tolerance:Number = 0;
    }
}
