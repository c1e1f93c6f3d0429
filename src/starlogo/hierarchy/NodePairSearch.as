package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Searches the items of a node of one tree and of a node of another for the best pair: the first to touch, or the nearest. Abstract: subclasses
     * know the items.
     *
     * @private
     */
    public class NodePairSearch
    {
        /**
         * Finds the time or the distance of the best pair of items.
         *
         * @param treeA the first model's tree
         * @param a a node of it
         * @param treeB the second model's tree
         * @param b a node of it
         * @param bounds <code>least</code> is the best time or distance so far, and <code>current</code> receives that of the two nodes. If it is not
         *     better, it need not be exact. If it is, the items or points of the best pair are replaced too
         */
        public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):void
        {
            throw new IllegalOperationError(this + " does not implement findBest");
        }
    }
}
