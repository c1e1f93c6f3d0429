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
    public final class TreesAndFits extends Trees
    {
        private var _fits:TightestFits;

        /** @param greatLand the models' hierarchies and structures */
        public function TreesAndFits(greatLand:GreatLand)
        {
            super(greatLand);
            _fits = new TightestFits(greatLand);
        }

        /** @inheritDoc */
        override public function kindOf(agent:Agent):int
        {
            return agent.hierarchical ? ModelShape.TREE : _fits.kindOf(agent);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            if (shape.kind == ModelShape.TREE)
            {
                super.bind(shape, agent);
                return;
            }
            _fits.bind(shape, agent);
        }
    }
}
