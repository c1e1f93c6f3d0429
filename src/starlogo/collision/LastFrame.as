package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.FrameInput;

    use namespace engine;

    /** What a Collision keeps of its last frame: the list as it was when the frame began, and which collider has searched it. */
    internal final class LastFrame
    {
        /** The engine's collider that has searched the list; null before the first frame, and for a system that is not the engine's. */
        public var collider:Collider = null;

        /** True while a frame runs, and after a frame that has refused its list or could not compute a contact. Errors of handlers do not count. */
        public var hasFailed:Boolean = false;

        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        // Whether the game has got the list, so that it may have changed it. The number of the list in the collider's table, or -1.
        private var _isLent:Boolean = false;
        private var _listNumber:int = -1;

        /** The list. */
        public function get agents():Vector.<Agent>
        {
            return _agents;
        }

        /** Returns the list to the game, which may change it. */
        public function lendAgents():Vector.<Agent>
        {
            _isLent = true;
            return _agents;
        }

        /**
         * Copies the list of a frame, unless the frame before had the same list.
         *
         * @param searchedBy the engine's collider that has searched it, or null
         */
        public function keep(list:Vector.<Agent>, searchedBy:Collider):void
        {
            var number:int = searchedBy == null ? -1 : searchedBy.search.table.list.listNumber;
            if (_isLent || number < 0 || number != _listNumber || searchedBy !== collider)
            {
                if (list === _agents)
                {
                    // the game's own list, from now on
                    _agents = new Vector.<Agent>();
                }
                FrameInput.copyList(list, _agents);
            }
            _listNumber = number;
            collider = searchedBy;
        }
    }
}
