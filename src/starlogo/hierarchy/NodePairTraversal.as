package starlogo.hierarchy
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the best pair of nodes of two trees, by branch and bound, depth-first (thesis §4.6; Larsen, Gottschalk, Lin and Manocha, "Fast
     * proximity queries with swept sphere volumes", 1999). A node's box encloses its children's boxes. So a pair is skipped if nothing
     * below it can be better than the best pair so far. The nodes that decide are leaves or at their depth limit.
     *
     * <p>Which pair is best depends on the question, and each question has a subclass: whether two standing trees overlap, when two moving
     * trees first touch, how far two trees are apart. A sphere, capsule or box is a tree of one node: see StructureLeaf.</p>
     *
     * <p>Bounds are fields and not arguments or results, because JavaScript engines allocate an object for each Number that functions
     * pass.</p>
     *
     * @private
     */
    public class NodePairTraversal
    {
        /** The number of pairs of nodes visited. The caller sets it to 0. */
        public var nodeVisits:int = 0;

        /** For standing trees: whether the roots overlapped although the trees do not. */
        public var rootsOverlapped:Boolean;

        /** The best time or distance found, or Infinity. */
        public var least:Number;

        /** The best pair of nodes. Undefined if none is found. */
        public var firstA:HierarchyNode = null;
        public var firstB:HierarchyNode = null;

        /** The least bound that there can be. A pair with this bound ends the search. */
        protected var lowest:Number = 0;

        /** The pose of the second tree's nodes in the first model's space. */
        protected var pose:RelativePose;

        /** A lower bound of the current pair's time or distance. Before <code>estimate()</code>, the parent pair's lower bound. */
        protected var bound:Number;

        /** The pairs still to visit. */
        protected var nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();

        // The bounds of these pairs.
        private var _bounds:Vector.<Number> = new Vector.<Number>();

        /**
         * Finds the best pair of nodes that decide.
         *
         * @param pose the pose of the second tree's nodes in the first model's space
         * @param a the root of the first tree
         * @param depthA how many of its levels are visited
         * @param b the root of the second tree
         * @param depthB how many of its levels are visited
         * @param leaves decides about such nodes; null if their boxes decide
         * @return whether there is such a pair
         */
        public function find(pose:RelativePose, a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, leaves:LeafTest):Boolean
        {
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (this.pose !== pose)
            {
                this.pose = pose;
            }
            var stack:Vector.<HierarchyNode> = nodes;
            var bounds:Vector.<Number> = _bounds;
            var scale:Number = pose.placement.size;
            var top:int = 0;
            var visits:int = 1;
            least = Infinity;
            bound = lowest;
            begin(a, b);
            estimate(a, b);
            while (true)
            {
                if (bound < least)
                {
                    var aEnds:Boolean = a.stopDepth >= depthA;
                    var bEnds:Boolean = b.stopDepth >= depthB;
                    if (!aEnds || !bEnds)
                    {
                        // The better of the two pairs with a child comes first.
                        var dividesA:Boolean = bEnds || !aEnds && a.radius >= scale * b.radius;
                        var divided:HierarchyNode = dividesA ? a : b;
                        if (divided.low == null)
                        {
                            divided.goesBelow(dividesA ? depthA : depthB);
                        }
                        var otherA:HierarchyNode = dividesA ? a.low : a;
                        var otherB:HierarchyNode = dividesA ? b : b.low;
                        a = dividesA ? a.high : a;
                        b = dividesA ? b : b.high;
                        var above:Number = bound;
                        estimate(otherA, otherB);
                        var other:Number = bound;
                        bound = above;
                        estimate(a, b);
                        visits += 2;
                        if (other < bound)
                        {
                            var node:HierarchyNode = a;
                            a = otherA;
                            otherA = node;
                            node = b;
                            b = otherB;
                            otherB = node;
                            above = bound;
                            bound = other;
                            other = above;
                        }
                        if (other < least)
                        {
                            stack[2 * top] = otherA;
                            stack[2 * top + 1] = otherB;
                            bounds[top] = other;
                            top++;
                        }
                        continue;
                    }
                    settle(a, b, leaves);
                    if (bound < least)
                    {
                        least = bound;
                        firstA = a;
                        firstB = b;
                    }
                }
                if (top == 0 || !(least > lowest))
                {
                    nodeVisits += visits;
                    return least < Infinity;
                }
                top--;
                a = stack[2 * top];
                b = stack[2 * top + 1];
                bound = bounds[top];
            }
            return false;
        }

        /** Prepares the traversal of two trees. */
        protected function begin(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /** Sets <code>bound</code> for a pair of nodes. A bound that is not less than <code>least</code> need not be exact. */
        protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /**
         * Sets <code>bound</code> to the time or distance of a pair that decides. If it is not less than <code>least</code>, it need not be
         * exact.
         */
        protected function settle(a:HierarchyNode, b:HierarchyNode, leaves:LeafTest):void
        {
        }
    }
}
