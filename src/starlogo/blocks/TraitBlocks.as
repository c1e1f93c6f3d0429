package starlogo.blocks
{
    import starlogo.agents.Agent;

    /**
     * The blocks for how an agent or a breed collides: "set hierarchical", "set collision depth", "collide as"
     * (thesis §7.1 to §7.3). What is set for a breed counts for its agents and, by <code>welcome()</code>, for those that join it later.
     */
    public class TraitBlocks
    {
        // in front of every key: a breed may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        private static const STRUCTURES:Array = [Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE];

        private var _agents:Vector.<Agent>;

        // By breed, the traits that were set, by their names.
        private var _breeds:Object = {};

        /**
         * Nothing is set.
         *
         * @param agents the game's own list of its agents, which is not copied
         * @throws ArgumentError if it is null
         */
        public function TraitBlocks(agents:Vector.<Agent>)
        {
            if (agents == null)
            {
                throw new ArgumentError("a list of agents is needed, not null");
            }
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
         * @param isOn whether the combination takes it for its hierarchy
         * @throws BlockError if it is neither
         */
        public function setHierarchical(subject:Object, isOn:Boolean):void
        {
            BlockSubject.check("set hierarchical", subject);
            apply(subject, "hierarchical", isOn);
        }

        /**
         * The block "set collision depth".
         *
         * @param subject an agent, or the name of a breed
         * @param levels how many levels of its hierarchy count, from 1; 0 for as many as the collision system says
         * @throws BlockError if it is neither, or the levels are no such number
         */
        public function setCollisionDepth(subject:Object, levels:Number):void
        {
            BlockSubject.check("set collision depth", subject);
            if (!(levels >= 0 && levels <= int.MAX_VALUE && levels % 1 == 0))
            {
                throw new BlockError("set collision depth", "needs a whole number: 1 is the coarsest, greater is more precise, and 0 leaves it to the"
                        + " collision system. It got " + levels + ".");
            }
            apply(subject, "traversalDepth", levels);
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
            BlockSubject.check("collide as", subject);
            if (STRUCTURES.indexOf(structure) < 0)
            {
                throw new BlockError("collide as", "does not know " + BlockSubject.nameOf(structure) + ". Choose one of these: " + STRUCTURES.join(", ") + ".");
            }
            apply(subject, "collideAs", structure);
        }

        /** Gives an agent that joins the game, or has changed its breed, what was set for the breed. */
        public function welcome(agent:Agent):void
        {
            var traits:Object = _breeds[PREFIX + agent.breed];
            for (var trait:String in traits)
            {
                agent[trait] = traits[trait];
            }
        }

        /** Forgets what was set for breeds, as before a program runs anew. Agents stay as they are. */
        public function forgetBreeds():void
        {
            _breeds = {};
        }

        private function apply(subject:Object, trait:String, value:Object):void
        {
            if (subject is Agent)
            {
                subject[trait] = value;
                return;
            }
            var key:String = PREFIX + subject;
            _breeds[key] ||= {};
            _breeds[key][trait] = value;
            for each (var agent:Agent in _agents)
            {
                if (agent.breed == subject)
                {
                    agent[trait] = value;
                }
            }
        }
    }
}
