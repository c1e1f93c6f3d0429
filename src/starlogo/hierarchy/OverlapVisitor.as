package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides about the pairs of nodes at which an OverlapTraversal ends, by their items: whether they touch. Abstract: subclasses know the items.
     *
     * @private
     */
    public class OverlapVisitor
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
