package starlogo.blocks
{
    import starlogo.agents.Agent;

    /**
     * The blocks that say how an agent or a breed collides: "set hierarchical", "set collision depth", "collide as"
     * (thesis §7.1 to §7.3). What is set for a breed goes for those that are there and, by <code>welcome()</code>, for those that come later.
     */
    public class TraitBlocks
    {
        // in front of every key: a breed may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        private static const STRUCTURES:Array = [Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE];

        private var _agents:Vector.<Agent>;
        private var _breeds:Object = {};

        /**
         * Nothing is set.
         *
         * @param agents those of the game, a list that goes on being the game's
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
         * @param whom an agent, or the name of a breed
         * @param isOn whether the combination takes it for its hierarchy
         * @throws BlockError if it is neither
         */
        public function setHierarchical(whom:Object, isOn:Boolean):void
        {
            Whom.check("set hierarchical", whom);
            var traits:BreedTraits = new BreedTraits();
            traits.hierarchical = isOn;
            apply(whom, traits);
        }

        /**
         * The block "set collision depth".
         *
         * @param whom an agent, or the name of a breed
         * @param levels how many levels of its hierarchy count, from 1; 0 for as many as the collision system says
         * @throws BlockError if it is neither, or the levels are no such number
         */
        public function setCollisionDepth(whom:Object, levels:Number):void
        {
            Whom.check("set collision depth", whom);
            if (!(levels >= 0 && levels <= int.MAX_VALUE && levels % 1 == 0))
            {
                throw new BlockError("set collision depth", "needs a whole number: 1 is the coarsest, greater is more precise, and 0 leaves it to the"
                        + " collision system. It got " + levels + ".");
            }
            var traits:BreedTraits = new BreedTraits();
            traits.depth = int(levels);
            apply(whom, traits);
        }

        /**
         * The block "collide as".
         *
         * @param whom an agent, or the name of a breed
         * @param structure one of structureNames
         * @throws BlockError if it is neither, or the structure none of them
         */
        public function collideAs(whom:Object, structure:String):void
        {
            Whom.check("collide as", whom);
            if (STRUCTURES.indexOf(structure) < 0)
            {
                throw new BlockError("collide as", "does not know " + Whom.said(structure) + ". Choose one of these: " + STRUCTURES.join(", ") + ".");
            }
            var traits:BreedTraits = new BreedTraits();
            traits.collideAs = structure;
            apply(whom, traits);
        }

        /** Gives an agent that joins the game, or has changed its breed, what was set for the breed. */
        public function welcome(agent:Agent):void
        {
            var traits:BreedTraits = _breeds[PREFIX + agent.breed] as BreedTraits;
            if (traits != null)
            {
                traits.applyTo(agent);
            }
        }

        /** Forgets what was set for breeds, as before a program runs anew. Agents stay as they are. */
        public function forgetBreeds():void
        {
            _breeds = {};
        }

        private function apply(whom:Object, traits:BreedTraits):void
        {
            if (whom is Agent)
            {
                traits.applyTo(whom as Agent);
                return;
            }
            remember(whom as String, traits);
            for each (var agent:Agent in _agents)
            {
                if (agent.breed == whom)
                {
                    traits.applyTo(agent);
                }
            }
        }

        private function remember(breed:String, traits:BreedTraits):void
        {
            var known:BreedTraits = _breeds[PREFIX + breed] as BreedTraits;
            if (known == null)
            {
                known = new BreedTraits();
                _breeds[PREFIX + breed] = known;
            }
            known.hierarchical = traits.hierarchical == null ? known.hierarchical : traits.hierarchical;
            known.depth = traits.depth < 0 ? known.depth : traits.depth;
            known.collideAs = traits.collideAs == null ? known.collideAs : traits.collideAs;
        }
    }
}
