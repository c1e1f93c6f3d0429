package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.data.keyOf;
    import starlogo.data.requireGiven;
    import starlogo.handlers.warnOfMissingBreeds;

    /**
     * The blocks that set how an agent or a breed collides: "set hierarchical", "set collision depth", "collide as" (thesis §7.1 to §7.3),
     * and "one way".
     * A setting for a breed counts for its agents. Call <code>welcome()</code> for agents that join the breed later. So a breed need not have agents
     * yet, and one that is misspelled is no error, but only warned of.
     */
    public class TraitBlocks
    {
        private static const STRUCTURES:Array = [Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL];

        private var _agents:Vector.<Agent>;

        // By the key of a breed: the traits that were set, by their names.
        private var _breeds:Object = {};

        /**
         * Creates blocks without settings.
         *
         * @param agents the game's own list of its agents; it is not copied
         * @throws ArgumentError if it is null
         */
        public function TraitBlocks(agents:Vector.<Agent>)
        {
            requireGiven("the list of agents", agents);
            _agents = agents;
        }

        /** The structures that "collide as" offers. */
        public static function get structureNames():Array
        {
            return STRUCTURES.concat();
        }

        /**
         * The block "set hierarchical".
         *
         * @param subject an agent, or the name of a breed
         * @param isOn whether the combination uses the agent's hierarchy
         * @throws BlockError if the subject is neither
         */
        public function setHierarchical(subject:Object, isOn:Boolean):void
        {
            apply("set hierarchical", subject, "hierarchical", isOn);
        }

        /**
         * The block "set collision depth".
         *
         * @param subject an agent, or the name of a breed
         * @param levels the number of levels of the hierarchy that are tested, from 1; with 0 the collision system decides
         * @throws BlockError if the subject is neither, or levels is no such number
         */
        public function setCollisionDepth(subject:Object, levels:Number):void
        {
            if (!(levels >= 0 && levels <= int.MAX_VALUE && levels % 1 == 0))
            {
                throw new BlockError("set collision depth", "needs a whole number: 1 is the coarsest, greater is more precise, and 0 leaves it to the"
                        + " collision system. It got " + levels + ".");
            }
            apply("set collision depth", subject, "traversalDepth", levels);
        }

        /**
         * The block "collide as".
         *
         * @param subject an agent, or the name of a breed
         * @param structure one of structureNames
         * @throws BlockError if the subject is neither, or the structure is not one of structureNames
         */
        public function collideAs(subject:Object, structure:String):void
        {
            if (STRUCTURES.indexOf(structure) < 0)
            {
                throw new BlockError("collide as", "does not know " + BlockChecks.nameOf(structure) + ". Choose one of these: " + STRUCTURES.join(", ") + ".");
            }
            apply("collide as", subject, "collideAs", structure);
        }

        /**
         * The block "one way": the agent stops only what comes from above. See Agent.isOneWay.
         *
         * @param subject an agent, or the name of a breed
         * @param isOn whether others that walk or slide pass it from below and from the side
         * @throws BlockError if the subject is neither
         */
        public function setOneWay(subject:Object, isOn:Boolean):void
        {
            apply("one way", subject, "isOneWay", isOn);
        }

        /**
         * Gives an agent the settings of its breed. Call it when an agent has joined the game or changed its breed. What its former breed has
         * set stays, unless the new breed sets it too.
         *
         * @throws ArgumentError if the agent is null
         */
        public function welcome(agent:Agent):void
        {
            requireGiven("agent", agent);
            var traits:Object = _breeds[keyOf(agent.breed)];
            for (var trait:String in traits)
            {
                agent[trait] = traits[trait];
            }
        }

        /** Forgets the settings of breeds. Call it before a program starts again. Agents keep their traits. */
        public function forgetBreeds():void
        {
            _breeds = {};
        }

        // Sets a trait of the agent, or of the breed's agents.
        private function apply(block:String, subject:Object, trait:String, value:Object):void
        {
            BlockChecks.requireTraitSubject(block, subject);
            if (subject is Agent)
            {
                subject[trait] = value;
                return;
            }
            var key:String = keyOf(subject as String);
            _breeds[key] ||= {};
            _breeds[key][trait] = value;
            for each (var agent:Agent in _agents)
            {
                if (agent.breed == subject)
                {
                    agent[trait] = value;
                }
            }
            warnOfMissingBreeds(new <String>[subject as String], _agents, null);
        }
    }
}
