package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides about a leaf of one tree and a leaf of another by their contents: whether they touch, when they touch, or how far they are apart.
     * Abstract: subclasses know the contents.
     *
     * @private
     */
    public class LeafPairTest
    {
        /**
         * Whether a leaf of the first model touches a leaf of the second; or, with bounds, whether they touch no later than the best pair so far, or
         * are nearer.
         *
         * @param treeA the first model's tree
         * @param a a leaf of it
         * @param treeB the second model's tree
         * @param b a leaf of it
         * @param bounds <code>least</code> is the best time or distance so far, and <code>current</code> receives that of the two leaves. If it is not
         *     better, it need not be exact. Null for models that stand
         */
        public function testLeaves(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):Boolean
        {
            throw new IllegalOperationError(this + " does not implement testLeaves");
        }
    }
}
