package starlogo.queries
{
    import starlogo.agents.Agent;

    /**
     * Says which agents count in a question. What is null says nothing; an agent counts if all that is set lets it.
     *
     * <p>An agent that does not count costs a question no more than these comparisons. Everything may be changed between questions.</p>
     */
    public final class AgentFilter
    {
        /** Only agents of these breeds. */
        public var breeds:Vector.<String> = null;

        /** No agents of these breeds. */
        public var exceptBreeds:Vector.<String> = null;

        /** None of these agents. */
        public var except:Vector.<Agent> = null;

        /**
         * <code>function(agent:Agent):Boolean</code>, asked last: of as few agents as the answer needs, the nearest first where the answer is in
         * the order of distance. It may ask questions of its own.
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

        /** Whether an agent counts, but for <code>accepts</code>. */
        internal function admits(agent:Agent):Boolean
        {
            if (breeds != null && breeds.indexOf(agent.breed) < 0)
            {
                return false;
            }
            if (exceptBreeds != null && exceptBreeds.indexOf(agent.breed) >= 0)
            {
                return false;
            }
            return except == null || except.indexOf(agent) < 0;
        }
    }
}
