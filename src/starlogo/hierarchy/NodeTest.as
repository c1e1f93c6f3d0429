package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Tests the nodes of a tree that decide, in the order in which a motion or a ray may meet them, or from the nearest on. Abstract.
     *
     * @private
     */
    public class NodeTest
    {
        /**
         * How far along the motion or the ray nodes are tested, or how far away: where the nearest node so far is met. Before the first one, the
         * end. A test that needs no more nodes sets it to -Infinity.
         */
        public var limit:Number = 0;

        /**
         * Tests a node: its box, or its items.
         *
         * @param tree the tree
         * @param node the node
         */
        public function testNode(tree:BoxTree, node:int):void
        {
            throw new IllegalOperationError(this + " does not implement testNode");
        }
    }
}
