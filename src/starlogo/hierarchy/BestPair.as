package starlogo.hierarchy
{
    import starlogo.convex.ClosestPoints;

    /**
     * The best pair of a BestPairTraversal so far, and the bounds of the search: times or distances. They are fields and not arguments or results,
     * because JavaScript engines allocate an object for each Number that functions pass.
     *
     * @private
     */
    public final class BestPair
    {
        /** The best time or distance found, or Infinity. */
        public var least:Number = Infinity;

        /** For times: the two that touch first, which are nodes, or slots if a visitor decides by items. Undefined if none touch. */
        public var a:int = 0;
        public var b:int = 0;

        /** For distances: the closest points of the best pair, and their distance. */
        public var points:ClosestPoints = new ClosestPoints();

        /** A lower bound of the current pair's time or distance. Before it is estimated, the parent pair's lower bound. */
        public var current:Number = 0;
    }
}
