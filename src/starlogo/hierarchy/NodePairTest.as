package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides about a node of one tree and a node of another by their items: whether they touch, when they touch, or how far they are apart.
     * Abstract: subclasses know the items.
     *
     * @private
     */
    public class NodePairTest
    {
        /**
         * Whether a node of the first model touches a node of the second; or, with bounds, whether they touch no later than the best pair so far, or
         * are nearer.
         *
         * @param treeA the first model's tree
         * @param a a node of it
         * @param treeB the second model's tree
         * @param b a node of it
         * @param bounds <code>least</code> is the best time or distance so far, and <code>current</code> receives that of the two nodes. If it is not
         *     better, it need not be exact. Null for models that stand
         */
        public function testNodes(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):Boolean
        {
            throw new IllegalOperationError(this + " does not implement testNodes");
        }
    }
}
