package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.search.FrameInput;

    /** What a Collision keeps of its last frame: the list as it was when the frame began, and which collider has searched it. */
    internal final class LastFrame
    {
        /** The engine's collider that has searched the list; null before the first frame, and for a system that is not the engine's. */
        public var collider:Collider = null;

        /** True while a frame runs, and after a frame that has refused its list or could not compute a contact. Errors of handlers do not count. */
        public var hasFailed:Boolean = false;

        /** The list. A game gets it, and may change it. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * Copies the list of a frame.
         *
         * @param searchedBy the engine's collider that has searched it, or null
         */
        public function keep(list:Vector.<Agent>, searchedBy:Collider):void
        {
            if (list === agents)
            {
                // the game's own list, from now on
                agents = new Vector.<Agent>();
            }
            FrameInput.copyList(list, agents);
            collider = searchedBy;
        }
    }
}
