package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides about the pairs of nodes at which a BestPairTraversal ends, by their items: which of these touch first, or are the nearest. Abstract:
     * subclasses know the items.
     *
     * @private
     */
    public class BestPairVisitor
    {
        /**
         * Finds the time or the distance of the best pair of items.
         *
         * @param treeA the first model's tree
         * @param a a node of it
         * @param treeB the second model's tree
         * @param b a node of it
         * @param best <code>least</code> is the best time or distance so far, and <code>current</code> receives that of the two nodes. If it is not
         *     better, it need not be exact. If it is, the items or points of the best pair are replaced too. They may be if it is as good
         */
        public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, best:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement findBest");
        }
    }
}
