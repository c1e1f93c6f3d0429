package starlogo.hierarchy
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.intersection.TriangleTest;

    /**
     * Decides about two leaves by their contents: whether they touch, when they touch, or how far they are apart. Abstract: subclasses
     * know the contents. <code>least</code> is the best time or distance so far.
     *
     * @private
     */
    public class LeafTest extends TriangleTest
    {
        /** The number of triangles, or of pairs of triangles, tested or measured. The caller sets it to 0. */
        public var triangleTests:int = 0;

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
        public function touch(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            return true;
        }

        /**
         * For moving models, finds the contact of the contents that touch first, at the pose's time. It is in the first model's space.
         *
         * @param out receives the contact
         */
        public function findContact(out:ContactPoint):void
        {
        }
    }
}
