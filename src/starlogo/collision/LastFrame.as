package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.handlers.TouchTracker;
    import starlogo.search.CollisionSearch;

    /**
     * What a Collision keeps of its last frame, as a record: the list as it was when the frame began, which search has read it, and the touches.
     *
     * @private
     */
    public final class LastFrame
    {
        /**
         * The search that has read the list. It is null before the first frame, while a frame runs, after a frame that has refused its list or could not
         * compute a contact, and for a system that is not the engine's. Errors of handlers do not count.
         */
        public var search:CollisionSearch = null;

        /** The list. A game gets it, and must not change it. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /** The pairs that touch, with which it compares those of the next frame. */
        public var tracker:TouchTracker = new TouchTracker();
    }
}
