package starlogo.blocks
{
    import starlogo.agents.Agent;

    /** How the agents of a breed collide, as far as a block said so; null and -1 where none did. */
    internal final class BreedTraits
    {
        /** Whether it is hierarchical: a Boolean, or null. */
        public var hierarchical:Object = null;

        /** The levels, or -1. */
        public var depth:int = -1;

        /** The structure, or null. */
        public var collideAs:String = null;

        /** Nothing was said yet. */
        public function BreedTraits()
        {
        }

        /** Gives an agent what was said. */
        public function applyTo(agent:Agent):void
        {
            if (hierarchical != null)
            {
                agent.hierarchical = hierarchical;
            }
            if (depth >= 0)
            {
                agent.traversalDepth = depth;
            }
            if (collideAs != null)
            {
                agent.collideAs = collideAs;
            }
        }
    }
}
