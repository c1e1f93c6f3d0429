package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.HierarchyStrategy;
    import starlogo.search.ShapeStrategy;

    /** What the HierarchicalCollider and the CombinationCollider have in common: how deep they look into hierarchies. */
    public class PreciseCollider extends Collider
    {
        private var _hierarchy:HierarchyStrategy;

        /**
         * For these two only.
         *
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @param hierarchy what of it tests hierarchies
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
         * Whether triangles decide between two hierarchies, so that the answer is the models' own. Leaves that overlap then are
         * looked into, no depth limit counts, and a model that is inside of another without touching its surface collides with it if
         * that surface is closed. An agent whose model has no triangles is decided by the leaves of its hierarchy, and so are a
         * hierarchy and a structure.
         *
         * <p>The first frame that an exact collider meets a model in takes some time to prepare its triangles, tens of
         * milliseconds for thousands, unless GreatLand.prepareExact was set when the model was added. So does the first frame that
         * any other meets it in without a hit: whether one is inside of the other is decided by triangles at every depth.</p>
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
