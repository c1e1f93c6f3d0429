package starlogo.search
{
    import starlogo.convex.ContactPoint;

    /**
     * How and when two agents touch.
     *
     * @private
     */
    public final class FoundContact
    {
        /** The contact. Its normal points from the second agent to the first. */
        public var point:ContactPoint = new ContactPoint();

        /** The time of the touch in the motions of the two, from 0 to 1; 1 if neither sweeps. */
        public var time:Number = 1;

        /** The speed at which the two came together along the normal, in patches a frame; 0 if neither sweeps. */
        public var approachSpeed:Number = 0;
    }
}
