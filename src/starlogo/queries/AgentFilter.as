package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.agents.warnOfBreeds;
    import starlogo.data.warnOfNoParameters;
    import starlogo.engine;

    use namespace engine;

    /**
     * Chooses the agents that count in a question, or that take part in a Collision. A property that is null excludes no agent. An agent counts
     * if no property excludes it.
     *
     * <p>If an agent is excluded, a question makes no further test of it, and a Collision makes no test of it at all. You may change all
     * properties between questions and between frames.</p>
     */
    public final class AgentFilter extends AgentPredicate
    {
        /** Only agents of these breeds count. If the list is empty, no agent counts. */
        public var breeds:Vector.<String> = null;

        /** Agents of these breeds do not count. */
        public var exceptBreeds:Vector.<String> = null;

        /** These agents do not count. Null among them is nobody. */
        public var except:Vector.<Agent> = null;

        /**
         * A function that decides about one agent: <code>function(agent:Agent):Boolean</code>. It returns true if the agent counts. It is called
         * last, after all other properties.
         *
         * <p>A question calls it for as few agents as the answer needs. If the answer is sorted by distance, it begins with the nearest agent. Motions
         * and casts of shapes call it for every agent whose extents are near the way, in the order of the list. A walk calls it
         * again if it pushes its agent out of something, and again if a one-way platform has risen into the agent. It calls it once more for a
         * platform that has moved, if the platform would carry the agent. A Collision calls it once a frame for each agent that the other
         * properties do not exclude.</p>
         *
         * <p>The function may ask questions itself. It must not change what the AgentQueries sees. So it must not call <code>update()</code> or
         * <code>refresh()</code>. It must not call <code>moveUntilTouch()</code>, <code>slide()</code> or <code>walk()</code> for an agent in the
         * list.</p>
         */
        public var accepts:Function = null;

        /** Begins as a filter that excludes no agent. */
        public function AgentFilter()
        {
        }

        /**
         * A filter that lets only some breeds count.
         *
         * @param names the names of the breeds, one after the other
         * @throws ArgumentError if something else is among them, for example a list of names
         */
        public static function ofBreeds(...names):AgentFilter
        {
            for (var i:int = 0; i < names.length; i++)
            {
                var name:Object = names[i];
                if (!(name is String))
                {
                    var kind:String = name != null && typeof name == "object" ? "the list or object " : "";
                    throw new ArgumentError("ofBreeds() takes names, one after the other, not " + kind + name);
                }
            }
            var filter:AgentFilter = new AgentFilter();
            filter.breeds = Vector.<String>(names);
            return filter;
        }

        /** @inheritDoc */
        override public function admits(agent:Agent):Boolean
        {
            var breed:String = agent.breed;
            return (breeds == null || breeds.indexOf(breed) >= 0) && (exceptBreeds == null || exceptBreeds.indexOf(breed) < 0)
                && (except == null || except.indexOf(agent) < 0) && (accepts == null || accepts(agent));
        }

        /** @private */
        override engine function checkNames(agents:Vector.<Agent>):void
        {
            warnOfBreeds(breeds, agents);
            warnOfBreeds(exceptBreeds, agents);
            warnOfNoParameters(accepts, "accepts of a filter", "agent:Agent", "Boolean");
        }
    }
}
