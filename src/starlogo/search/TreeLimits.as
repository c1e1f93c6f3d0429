package starlogo.search
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;

    use namespace engine;

    /**
     * How far the trees of a collision system are tested: to which depth, and whether their triangles decide.
     *
     * @private
     */
    public final class TreeLimits
    {
        /** Whether the triangles decide. Then trees are tested down to them. */
        public var isExact:Boolean = false;

        private var _maxDepth:int = 5;

        /** Levels of each tree, if its agent has no limit of its own. @throws RangeError if it is set to less than 1 */
        public function get maxDepth():int
        {
            return _maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            if (value < 1)
            {
                throw new RangeError("maxDepth must be at least 1: " + value);
            }
            _maxDepth = value;
        }

        /** The number of levels to which trees are tested if their agents have no limits; BoxTree.EXACT if the triangles decide. */
        public function get defaultDepth():int
        {
            return isExact ? BoxTree.EXACT : Math.min(_maxDepth, BoxTree.LEAVES);
        }

        /** The number of levels to which the tree of a body is tested; BoxTree.EXACT if its triangles decide. */
        public function depthOf(body:Body):int
        {
            if (isExact && body.shape.tree.hasTriangles)
            {
                return BoxTree.EXACT;
            }
            var levels:int = body.depthLimit == 0 ? maxDepth : body.depthLimit;
            return isExact || levels > BoxTree.LEAVES ? BoxTree.LEAVES : levels;
        }
    }
}
