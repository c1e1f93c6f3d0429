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
        // A model of more triangles is probably a level.
        private static const MOST_TRIANGLES:int = 10000;

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
            warnOfLevel(shape, agent);
        }

        // A level is one large model, and a box around it is hardly what a game wants.
        private function warnOfLevel(shape:ModelShape, agent:Agent):void
        {
            var triangles:Vector.<uint> = greatLand.modelOf(shape.model).triangles;
            if (shape.kind == Agent.ANY_KIND && triangles != null && triangles.length > 3 * MOST_TRIANGLES)
            {
                warn(agent + " has " + triangles.length / 3 + " triangles, and collides as the structure around them: set hierarchical to true for a level, "
                        + "or choose a structure with collideAs");
            }
        }
    }
}
