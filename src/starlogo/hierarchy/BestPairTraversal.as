package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds the best pair of nodes of two trees, by branch and bound, depth-first (thesis §4.6; Larsen, Gottschalk, Lin and Manocha, "Fast
     * proximity queries with swept sphere volumes", 1999). A node's box encloses its children's boxes. So a pair is skipped if nothing
     * below it can be better than the best pair so far. Which nodes decide, says the BoxTree.
     *
     * <p>Which pair is best depends on the question, and each question has a subclass: when two moving trees first touch, how far two trees
     * are apart. Whether two standing trees overlap needs no bounds: see OverlapTraversal.</p>
     *
     * @private
     */
    public class BestPairTraversal
    {
        private var _best:BestPair = new BestPair();

        // The pairs of nodes still to visit, and their bounds. The next one is last.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodeBounds:Vector.<Number> = new Vector.<Number>();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function BestPairTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Finds the best pair of nodes that decide. A subclass calls it when all is set that does not depend on the nodes.
         *
         * @param pose the pose of the second tree's nodes in the first model's space
         * @param treeA the first tree
         * @param depthA how many of its levels are visited
         * @param treeB the second tree
         * @param depthB how many of its levels are visited
         * @param visitor decides about such nodes; null if their boxes decide
         * @return the best pair; the next search overwrites it
         */
        protected final function find(pose:RelativePose, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int, visitor:BestPairVisitor):BestPair
        {
            var endsA:Vector.<int> = treeA.endsUpToDepth;
            var endsB:Vector.<int> = treeB.endsUpToDepth;
            var nodes:Vector.<int> = _nodes;
            var bounds:Vector.<Number> = _nodeBounds;
            var out:BestPair = _best;
            var visits:int = 1;
            var top:int = 1;
            out.least = out.points.distance = Infinity;
            out.current = 0;
            estimate(pose, treeA, 0, treeB, 0, out);
            nodes[0] = 0;
            nodes[1] = 0;
            bounds[0] = out.current;
            while (top > 0 && out.least > 0)
            {
                top--;
                var a:int = nodes[2 * top];
                var b:int = nodes[2 * top + 1];
                var bound:Number = bounds[top];
                out.current = bound;
                if (!(bound < out.least))
                {
                    continue;
                }
                var aEnds:Boolean = endsA[a] >= depthA;
                var bEnds:Boolean = endsB[b] >= depthB;
                if (aEnds && bEnds)
                {
                    if (visitor != null)
                    {
                        visitor.findBest(treeA, a, treeB, b, out);
                    }
                    else
                    {
                        measure(pose, treeA, a, treeB, b, out);
                    }
                    out.least = out.current < out.least ? out.current : out.least;
                    continue;
                }
                var dividesA:Boolean = bEnds || !aEnds && pose.isFirstLarger(treeA, a, treeB, b);
                var leftA:int = dividesA ? treeA.left[a] : a;
                var leftB:int = dividesA ? b : treeB.left[b];
                var rightA:int = dividesA ? leftA + 1 : a;
                var rightB:int = dividesA ? b : leftB + 1;
                estimate(pose, treeA, leftA, treeB, leftB, out);
                var leftBound:Number = out.current;
                out.current = bound;
                estimate(pose, treeA, rightA, treeB, rightB, out);
                var rightBound:Number = out.current;
                visits += 2;
                // The better of the two pairs is last, so it is visited first.
                var isLeftBetter:Boolean = leftBound < rightBound;
                nodes[2 * top] = isLeftBetter ? rightA : leftA;
                nodes[2 * top + 1] = isLeftBetter ? rightB : leftB;
                bounds[top] = isLeftBetter ? rightBound : leftBound;
                top++;
                nodes[2 * top] = isLeftBetter ? leftA : rightA;
                nodes[2 * top + 1] = isLeftBetter ? leftB : rightB;
                bounds[top] = isLeftBetter ? leftBound : rightBound;
                top++;
            }
            _counts.nodeVisits += visits;
            return out;
        }

        /** Sets <code>out.current</code> for a pair of nodes. A bound that is not less than <code>out.least</code> need not be exact. */
        protected function estimate(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement estimate");
        }

        /**
         * Sets <code>out.current</code> to the time or distance of two boxes that decide. If it is less than <code>out.least</code>, also sets what
         * <code>out</code> has of the best pair. Otherwise it need not be exact.
         */
        protected function measure(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement measure");
        }
    }
}
