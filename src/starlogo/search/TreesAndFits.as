package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The shape of an agent is its model's hierarchy if its trait <code>hierarchical</code> is set, and else its model's tightest fit (thesis
     * §5).
     *
     * @private
     */
    public final class TreesAndFits extends ShapeChoice
    {
        private var _trees:Trees;
        private var _fits:TightestFits;

        /** @param greatLand the models' hierarchies and structures */
        public function TreesAndFits(greatLand:GreatLand)
        {
            super(greatLand);
            _trees = new Trees(greatLand);
            _fits = new TightestFits(greatLand);
        }

        /** @private */
        override engine function prepare(pairs:RowPairs):void
        {
            _trees.prepare(pairs);
        }

        /** @inheritDoc */
        override public function kindOf(agent:Agent):int
        {
            return agent.hierarchical ? ModelShape.TREE : _fits.kindOf(agent);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var choice:ShapeChoice = shape.kind == ModelShape.TREE ? _trees : _fits;
            choice.bind(shape, agent);
        }
    }
}
