package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.CombinationStrategy;
    import starlogo.search.HierarchyStrategy;
    import starlogo.search.TightestFitStrategy;

    /**
     * Takes the agents that are hierarchical for the hierarchies of their models, and all others for their tightest fits
     * (thesis §5): precise where a player looks, cheap everywhere else.
     *
     * <p>Two agents that are not hierarchical collide as in the TightestFitCollider, two that are as in the
     * HierarchicalCollider. Of one that is and one that is not, the hierarchy meets the structure: it is visited down to a
     * leaf, or to the depth limit, that the structure overlaps. An agent may become hierarchical, or cease to be, between
     * frames.</p>
     *
     * <p>The hierarchy is needed of models whose agents are hierarchical, the tightest fit of the others.</p>
     */
    public class CombinationCollider extends PreciseCollider
    {
        private var _structureTests:StructureTests;

        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadTightestFit and loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function CombinationCollider(greatLand:GreatLand)
        {
            var hierarchy:HierarchyStrategy = new HierarchyStrategy(greatLand);
            var tightestFit:TightestFitStrategy = new TightestFitStrategy(greatLand);
            _structureTests = new StructureTests(tightestFit);
            super(greatLand, new CombinationStrategy(tightestFit, hierarchy), hierarchy);
        }

        /** How the structures of two agents are tested that are not hierarchical. */
        public function get structureTests():StructureTests
        {
            return _structureTests;
        }
    }
}
