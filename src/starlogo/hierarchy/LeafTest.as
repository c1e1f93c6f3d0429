package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Tests leaves of a tree, in the order in which a motion or a ray may meet them, or from the nearest on. Abstract.
     *
     * @private
     */
    public class LeafTest
    {
        /**
         * How far along the motion or the ray leaves are tested, or how far away: where the nearest leaf so far is met. Before the first one, the
         * end. A test that needs no more leaves sets it to -Infinity.
         */
        public var limit:Number = 0;

        /**
         * Tests a leaf: its box, or its items.
         *
         * @param tree the tree
         * @param node the leaf
         */
        public function testLeaf(tree:BoxTree, node:int):void
        {
            throw new IllegalOperationError(this + " does not implement testLeaf");
        }
    }
}
