package starlogo.hierarchy
{
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
        public var least:Number = 0;

        /**
         * Tests a leaf. The numbers of its triangles are a range.
         *
         * @param node the leaf's number
         * @param first the first triangle's number
         * @param end the number after the last one
         */
        public function testLeaf(node:int, first:int, end:int):void
        {
        }
    }
}
