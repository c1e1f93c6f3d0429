package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * A collision system that is put around another, finds what that finds, and looks at it. To a Collision, to snapshots and to questions the
     * game is the same with it and without.
     */
    public interface CollisionObserver extends ContactSystem
    {
        /** The collision system that does the work. */
        function get collisionSystem():CollisionSystem;

        /**
         * Called when a frame's pairs are known, before the handlers.
         *
         * @param pairs the agents: a0, b0, a1, b1, ... To be read only
         * @param length how many of them there are; what comes after is left from other frames
         */
        function onPairs(pairs:Vector.<Agent>, length:int):void;

        /**
         * Called when a Collision's frame is over, handlers included.
         *
         * @param statistics the Collision's, of that frame; the next frame overwrites it
         */
        function onFrame(statistics:CollisionStatistics):void;
    }
}
