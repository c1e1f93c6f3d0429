package starlogo.blocks
{
    import starlogo.agents.Agent;

    /** How agents collide, as far as blocks have set it: a trait that no block has set is null or -1. */
    internal final class BreedTraits
    {
        private var _hierarchical:Object;
        private var _depth:int;
        private var _collideAs:String;

        /**
         * @param hierarchical whether they are hierarchical: a Boolean, or null
         * @param depth the levels, or -1
         * @param collideAs the structure, or null
         */
        public function BreedTraits(hierarchical:Object = null, depth:int = -1, collideAs:String = null)
        {
            _hierarchical = hierarchical;
            _depth = depth;
            _collideAs = collideAs;
        }

        /** These traits; where one is not set, that of an older set. */
        public function over(older:BreedTraits):BreedTraits
        {
            var hierarchical:Object = _hierarchical == null ? older._hierarchical : _hierarchical;
            return new BreedTraits(hierarchical, _depth < 0 ? older._depth : _depth, _collideAs || older._collideAs);
        }

        /** Gives an agent what is set. */
        public function applyTo(agent:Agent):void
        {
            if (_hierarchical != null)
            {
                agent.hierarchical = _hierarchical;
            }
            if (_depth >= 0)
            {
                agent.traversalDepth = _depth;
            }
            if (_collideAs != null)
            {
                agent.collideAs = _collideAs;
            }
        }
    }
}
