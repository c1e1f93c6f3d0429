package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;

    /**
     * Says which agents count in a question, or in a Collision. What is null says nothing; an agent counts if all that is set lets it.
     *
     * <p>An agent that does not count costs a question no more than these comparisons, and a Collision no test. Everything may be changed between
     * questions, and between frames.</p>
     */
    public final class AgentFilter extends AgentPredicate
    {
        /** Only agents of these breeds; none at all if it is empty. */
        public var breeds:Vector.<String> = null;

        /** No agents of these breeds. */
        public var exceptBreeds:Vector.<String> = null;

        /** None of these agents. */
        public var except:Vector.<Agent> = null;

        /**
         * <code>function(agent:Agent):Boolean</code>, asked last: of as few agents as the answer needs, the nearest first where the answer is in
         * the order of distance; by a Collision of all agents that the rest lets count, once a frame. It may ask questions of its own, but not
         * change what asks it: not by <code>update()</code>, <code>moved()</code>, <code>moveUntilTouch()</code> or <code>slide()</code>.
         */
        public var accepts:Function = null;

        /** A filter through which every agent comes. */
        public function AgentFilter()
        {
        }

        /** A filter for some breeds. */
        public static function ofBreeds(...names):AgentFilter
        {
            var filter:AgentFilter = new AgentFilter();
            filter.breeds = Vector.<String>(names);
            return filter;
        }

        /** @inheritDoc */
        override public function admits(agent:Agent):Boolean
        {
            if (breeds != null && !has(breeds, agent.breed))
            {
                return false;
            }
            if (exceptBreeds != null && has(exceptBreeds, agent.breed))
            {
                return false;
            }
            return (except == null || except.indexOf(agent) < 0) && (accepts == null || accepts(agent));
        }

        // in less time than indexOf, for few names
        private static function has(names:Vector.<String>, name:String):Boolean
        {
            var length:int = names.length;
            for (var i:int = 0; i < length; i++)
            {
                if (names[i] == name)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
