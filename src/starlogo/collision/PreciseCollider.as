package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.HierarchyStrategy;
    import starlogo.search.ShapeStrategy;

    /** What the HierarchicalCollider and the CombinationCollider have in common: how deep they visit hierarchies. */
    public class PreciseCollider extends Collider
    {
        private var _hierarchy:HierarchyStrategy;

        /**
         * For HierarchicalCollider and CombinationCollider only.
         *
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @param hierarchy the part of the strategy that tests hierarchies
         * @throws ArgumentError if greatLand is null
         */
        public function PreciseCollider(greatLand:GreatLand, strategy:ShapeStrategy, hierarchy:HierarchyStrategy)
        {
            super(greatLand, strategy);
            _hierarchy = hierarchy;
        }

        /**
         * How many levels of a hierarchy are visited, for agents whose own traversalDepth is 0 (§4.8); the root is one. A
         * number larger than a hierarchy has levels visits them all. A greater depth finds fewer false collisions, and never one
         * that a smaller depth does not.
         *
         * @throws RangeError if it is set to less than 1
         */
        public function get maxDepth():int
        {
            return _hierarchy.maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            if (value < 1)
            {
                throw new RangeError("maxDepth must be at least 1: " + value);
            }
            _hierarchy.maxDepth = value;
        }

        /**
         * Whether the triangles of overlapping leaves decide between two hierarchies. No depth limit applies then, and a model inside of
         * another, without touching its surface, collides with it if that surface is closed. Where a model has no triangles, and between a
         * hierarchy and a structure, the leaves decide.
         *
         * <p>The first frame in which an exact collider tests a model takes some time to prepare its triangles, tens of milliseconds for
         * thousands, unless GreatLand.prepareExact was set when the model was added. So does the first frame in which any other
         * collider tests it without finding a collision: triangles decide at every depth whether one model is inside of the other.</p>
         */
        public function get exact():Boolean
        {
            return _hierarchy.exact;
        }

        public function set exact(value:Boolean):void
        {
            _hierarchy.exact = value;
        }
    }
}
