package starlogo.hierarchy
{
    import starlogo.convex.ClosestPoints;

    /**
     * The best pair of a NodePairTraversal so far, and its bounds: times or distances. They are fields and not arguments or results, because
     * JavaScript engines allocate an object for each Number that functions pass.
     *
     * @private
     */
    public final class NodePairBounds
    {
        /** The best time or distance found, or Infinity. */
        public var least:Number = Infinity;

        /** For times: what touches first in the best pair, the two nodes, or the slots of two items if items decide. Undefined if none is found. */
        public var bestA:int = 0;
        public var bestB:int = 0;

        /** For distances: the closest points of the best pair, and their distance. */
        public var points:ClosestPoints = new ClosestPoints();

        /** A lower bound of the current pair's time or distance. Before it is estimated, the parent pair's lower bound. */
        public var current:Number = 0;
    }
}
