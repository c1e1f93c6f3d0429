package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.engine;

    use namespace engine;

    /** The list of a frame with a filter, as it was before the filter was asked, because a filter may change the game's list. */
    internal final class FilteredList
    {
        /** Whether an agent takes part, by its index in the list. */
        public var takePart:Vector.<Boolean> = new Vector.<Boolean>();

        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * Asks a filter about each agent of a list. An entry that is null takes part, because the collision system refuses it.
         *
         * @return a copy of the list, until the next call
         */
        public function ask(filter:AgentPredicate, agents:Vector.<Agent>):Vector.<Agent>
        {
            copyInto(_agents, agents);
            filter.checkNames(_agents);
            for (var i:int = 0; i < _agents.length; i++)
            {
                takePart[i] = _agents[i] == null || filter.admits(_agents[i]);
            }
            return _agents;
        }

        /** Makes a list a copy of another. */
        public static function copyInto(copy:Vector.<Agent>, agents:Vector.<Agent>):void
        {
            copy.length = agents.length;
            for (var i:int = 0; i < agents.length; i++)
            {
                // writing a reference costs more than comparing it
                if (copy[i] !== agents[i])
                {
                    copy[i] = agents[i];
                }
            }
        }
    }
}
