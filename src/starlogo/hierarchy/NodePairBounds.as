package starlogo.hierarchy
{
    /**
     * The bounds of a NodePairTraversal: times or distances. They are fields and not arguments or results, because JavaScript engines
     * allocate an object for each Number that functions pass.
     *
     * @private
     */
    public final class NodePairBounds
    {
        /** The best time or distance found, or Infinity. */
        public var least:Number = Infinity;

        /** A lower bound of the current pair's time or distance. Before it is estimated, the parent pair's lower bound. */
        public var current:Number = 0;
    }
}
