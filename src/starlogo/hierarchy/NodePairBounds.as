package starlogo.hierarchy
{
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

        /** The nodes of the best pair. Undefined if none is found. */
        public var bestA:int = 0;
        public var bestB:int = 0;

        /** A lower bound of the current pair's time or distance. Before it is estimated, the parent pair's lower bound. */
        public var current:Number = 0;
    }
}
