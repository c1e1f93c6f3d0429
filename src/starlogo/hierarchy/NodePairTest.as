package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides whether a node of one tree touches a node of another, by their items. Abstract: subclasses know the items.
     *
     * @private
     */
    public class NodePairTest
    {
        /**
         * Whether a node of the first model touches a node of the second.
         *
         * @param treeA the first model's tree
         * @param a a node of it
         * @param treeB the second model's tree
         * @param b a node of it
         */
        public function areTouching(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }
    }
}
