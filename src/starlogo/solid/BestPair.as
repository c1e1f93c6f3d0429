package starlogo.solid
{
    import starlogo.convex.ClosestPoints;

    /**
     * The best pair of a BestPairTraversal so far, as a record: for times two leaves or triangles, for distances two points. a is of the first
     * tree, and b of the second. It has the time or distance and the bound too, because JavaScript engines allocate an object for each Number that functions
     * pass.
     */
    internal final class BestPair
    {
        /** No larger time or distance counts. It is the best one found, or Infinity; a kernel of times may leave room for others at the same time. */
        public var limit:Number = Infinity;

        /** For times: when two first touch, or Infinity. */
        public var time:Number = Infinity;

        /** For times: the leaves that touch first, or the indices of triangles if a kernel tests these. Undefined if none touch. */
        public var a:int = 0;
        public var b:int = 0;

        /** For distances: the closest points of the best pair, and their distance. */
        public var points:ClosestPoints = new ClosestPoints();

        /** No part of the pair of nodes that is estimated has a smaller time or distance. Before it is estimated, the bound of its parent pair. */
        public var bound:Number = 0;
    }
}
