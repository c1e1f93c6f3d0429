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

        /** The best pair of nodes. Undefined if none is found. */
        public var nodeA:int = 0;
        public var nodeB:int = 0;

        /** For times, if items decide: the slots of the two that touch first. */
        public var slotA:int = 0;
        public var slotB:int = 0;

        /** For distances: the closest points of the best pair, and their distance. */
        public var points:ClosestPoints = new ClosestPoints();

        /** A lower bound of the current pair's time or distance. Before it is estimated, the parent pair's lower bound. */
        public var current:Number = 0;
    }
}
