package starlogo.queries
{
    import starlogo.GreatLand;
    import starlogo.collision.QuerySource;
    import starlogo.engine;
    import starlogo.search.NarrowPhase;
    import starlogo.search.TightestShapes;
    import starlogo.search.TreeShapes;

    use namespace engine;

    /**
     * What questions see agents as, in a game that asks for rays or walks and searches for no collisions. It sees them as a CombinationCollider
     * does: agents that are <code>hierarchical</code>, such as a level, as the trees or the triangles of their models, and all others as
     * their tightest fits. Pass it to SeenAgents. Rays do not meet bounding structures of a game's own here: they are refused with an
     * ArgumentError.
     *
     * <listing version="3.0">
     * var seen:SeenAgents = new SeenAgents(new LevelShapes(greatLand));
     * var rays:AgentRays = new AgentRays(seen);
     * </listing>
     */
    public final class LevelShapes extends QuerySource
    {
        private var _narrowPhase:NarrowPhase;

        /**
         * Sees agents as the models of a GreatLand.
         *
         * @param greatLand has the models
         * @throws ArgumentError if it is null
         */
        public function LevelShapes(greatLand:GreatLand)
        {
            _narrowPhase = new NarrowPhase(new TreeShapes(greatLand, new TightestShapes(greatLand)));
        }

        /**
         * The number of levels that a test visits in each tree, unless the agent has a <code>traversalDepth</code>. At least 1.
         *
         * @default 5
         * @throws RangeError if it is less than 1
         */
        public function get maxDepth():int
        {
            return _narrowPhase.treeLimits.maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            _narrowPhase.treeLimits.takeDepth(value);
        }

        /**
         * Whether the triangles of trees decide.
         *
         * @default false
         */
        public function get exact():Boolean
        {
            return _narrowPhase.treeLimits.exact;
        }

        public function set exact(value:Boolean):void
        {
            _narrowPhase.treeLimits.exact = value;
        }

        /** @private */
        override engine function findNarrowPhase():NarrowPhase
        {
            return _narrowPhase;
        }
    }
}
