package starlogo.hierarchy
{
    import starlogo.convex.ClosestPoints;

    /**
     * Decides about a leaf of one tree and a leaf of another by their contents: whether they touch, when they touch, or how far they are apart.
     * Abstract: subclasses know the contents. <code>least</code> is the best time or distance so far.
     *
     * @private
     */
    public class LeafPairTest
    {
        /** The best time or distance so far. */
        public var least:Number = 0;

        /** For distances: the closest points of the leaves tested, and their distance, in the first model's space. */
        public var points:ClosestPoints = null;

        /**
         * Whether a leaf of the first model touches a leaf of the second, or is nearer than <code>least</code>.
         *
         * @param treeA the first model's tree
         * @param a a leaf of it
         * @param treeB the second model's tree
         * @param b a leaf of it
         */
        public function testLeaves(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            return true;
        }
    }
}
