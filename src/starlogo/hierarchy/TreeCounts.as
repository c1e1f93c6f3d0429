package starlogo.hierarchy
{
    /**
     * Counts of what the queries of trees have done, as a record. Whoever made it sets it to 0.
     *
     * @private
     */
    public final class TreeCounts
    {
        /** The number of pairs of models tested, of which at least one is a tree. */
        public var pairTests:int = 0;

        /** The number of pairs of nodes visited, or of nodes and shapes. */
        public var nodeVisits:int = 0;

        /**
         * The number of pairs of triangles, or of a triangle and a structure, tested or measured. Pairs whose extents are apart do not count. Nor
         * do pairs of a triangle and a structure that the triangle's plane, or an axis, keeps apart.
         */
        public var triangleTests:int = 0;
    }
}
