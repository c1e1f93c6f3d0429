package starlogo.collision
{
    import starlogo.engine;
    import starlogo.search.ShapeChoice;

    use namespace engine;

    /** What the HierarchicalCollider and the CombinationCollider have in common: how deep they visit hierarchies. */
    public class TreeCollider extends Collider
    {
        /**
         * For HierarchicalCollider and CombinationCollider only.
         *
         * @param choice finds the shapes of agents
         */
        public function TreeCollider(choice:ShapeChoice)
        {
            super(choice);
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
            return pairs.trees.maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            if (value < 1)
            {
                throw new RangeError("maxDepth must be at least 1: " + value);
            }
            pairs.trees.maxDepth = value;
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
            return pairs.trees.exact;
        }

        public function set exact(value:Boolean):void
        {
            pairs.trees.exact = value;
        }
    }
}
