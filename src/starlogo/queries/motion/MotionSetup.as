package starlogo.queries.motion
{
    import starlogo.data.NumberList;

    /**
     * With what a motion was computed: its tolerances, its core, and the rows that stop it. Each motion of a Mover writes it. What follows a motion,
     * at its end or at its beginning, takes it.
     *
     * @private
     */
    public final class MotionSetup
    {
        /**
         * The slop, in patches. The core's nearest faces are that far behind the body's own, or less far if the body is slim, or its least
         * half-extent is less than two slops. <code>MovingBody.narrow()</code> makes the core smaller still, but not the slop larger.
         */
        public var slop:Number = 0;

        /** How far before a touch a slide ends, in patches. It is less than the slop, so the body can enter a place as wide as itself. */
        public var clearance:Number = 0;

        /**
         * How much of its least half-extent the core should lose, in patches: a slop, or more after <code>MovingBody.narrow()</code>. A slim or
         * small body loses less.
         */
        public var inset:Number = 0;

        /** The part of its size that the core loses. */
        public var shrink:Number = 0;

        /** Whether the body is too flat for its core to be narrower. */
        public var isFlat:Boolean = false;

        /** The rows that stop it. A row that a plane has taken the place of is not one of them, nor a one-way row that the body passed. */
        public var obstacles:NumberList = new NumberList();
    }
}
