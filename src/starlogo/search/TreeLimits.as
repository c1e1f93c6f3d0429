package starlogo.search
{
    import starlogo.hierarchy.BoxTree;

    /**
     * How far the trees of a collision system are tested: to which depth, and whether their triangles decide.
     *
     * @private
     */
    public final class TreeLimits
    {
        /** Levels of each tree, from 1 on, if its agent has no limit of its own. */
        public var maxDepth:int = 5;

        /** Whether the triangles decide. Then trees are tested down to them. */
        public var exact:Boolean = false;

        /** Sets the depth. Throws a RangeError if it is less than 1. */
        public function takeDepth(value:int):void
        {
            if (value < 1)
            {
                throw new RangeError("maxDepth must be at least 1: " + value);
            }
            maxDepth = value;
        }

        /** The number of levels to which the tree of a body is tested. */
        public function depthOf(body:Body):int
        {
            var depth:int = body.depth == 0 ? maxDepth : body.depth;
            return exact || depth > BoxTree.LARGEST_DEPTH ? BoxTree.LARGEST_DEPTH : depth;
        }
    }
}
