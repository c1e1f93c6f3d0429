package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.pairs.TreePairTests;

    use namespace engine;

    /**
     * The shape of an agent is its model's hierarchy (thesis §4), for all agents or only for those whose trait <code>hierarchical</code> is set. The
     * others then have their tightest fits (thesis §5).
     *
     * @private
     */
    public final class TreeChoice extends ShapeChoice
    {
        // The variant of a model's shape that is its tree. TightestFitChoice has lower variants, the kinds of structures.
        private static const TREE_VARIANT:int = BoundingStructure.KIND_COUNT;

        private var _fits:TightestFitChoice;

        /**
         * @param greatLand the models' hierarchies and structures
         * @param fits the shapes of agents that are not hierarchical; null if all agents have hierarchies
         */
        public function TreeChoice(greatLand:GreatLand, fits:TightestFitChoice = null)
        {
            super(greatLand);
            systemName = fits == null ? "a HierarchicalCollider" : "a CombinationCollider";
            _fits = fits;
        }

        /** @private The structures are those of fits, or of questions. */
        override engine function addTests(narrowPhase:NarrowPhase):void
        {
            super.addTests(narrowPhase);
            TreePairTests.addTo(narrowPhase);
        }

        /** @inheritDoc */
        override public function variantOf(agent:Agent):int
        {
            return _fits == null || agent.hierarchical ? TREE_VARIANT : _fits.variantOf(agent);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            if (shape.variant != TREE_VARIANT)
            {
                _fits.bind(shape, agent);
                return;
            }
            if (!greatLand.hierarchies.has(shape.modelName))
            {
                throw new ArgumentError(agent + ": its model was added while loadHierarchies was false; set it to true, and add the model again");
            }
            shape.setTree(greatLand.hierarchies.treeOf(shape.modelName));
        }
    }
}
