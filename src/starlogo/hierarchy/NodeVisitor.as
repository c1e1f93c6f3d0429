package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Tests the leaves of a BoxSearch, which calls it for each one, in the order in which its box may meet them, or from the nearest on. Abstract. A
     * subclass knows what is looked for, and whether the boxes of the leaves are tested or their primitives.
     *
     * @private
     */
    public class NodeVisitor
    {
        /**
         * How far the search goes. In <code>BoxSearch.visitMet()</code> it is a multiple of the box's motion: a time, or a distance if the motion has
         * length 1. In <code>BoxSearch.visitNear()</code> it is a distance from the box. Nodes beyond it are not visited. Whoever begins a search
         * sets it. A visitor that has found something makes it less, so that only better nodes follow.
         */
        public var limit:Number = 0;

        /** Ends the search: no node is within the limit any more. */
        protected final function endSearch():void
        {
            limit = -Infinity;
        }

        /**
         * Tests a leaf of the search.
         *
         * @param tree the tree
         * @param node the node
         */
        public function visit(tree:BoxTree, node:int):void
        {
            throw new IllegalOperationError(this + " does not implement visit");
        }
    }
}
