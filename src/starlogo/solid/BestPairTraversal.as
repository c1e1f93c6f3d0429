package starlogo.solid
{
    import flash.errors.IllegalOperationError;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;

    /**
     * Finds the best pair of leaves of two trees, by branch and bound, depth-first (thesis §4.6; Larsen, Gottschalk, Lin and Manocha, "Fast
     * proximity queries with swept sphere volumes", 1999). A node's box encloses its children's boxes. So a pair is skipped if nothing
     * below it can be better than the best pair so far.
     *
     * <p>Which pair is best depends on the question, and each question has a subclass: when two moving trees first touch, how far two trees
     * are apart. Whether two standing trees overlap needs no bounds: see OverlapTraversal.</p>
     */
    internal class BestPairTraversal
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
         * Finds the best pair of leaves: see BoxTree. A subclass calls it when all is set that does not depend on the nodes.
         *
         * @param kernel tests the triangles of two leaves; null if their boxes are tested
         * @return the best pair; the next search overwrites it
         */
        protected final function find(trees:TreePair, kernel:TrianglePairKernel):BestPair
        {
            var treeA:BoxTree = trees.a;
            var treeB:BoxTree = trees.b;
            var leafDepthsA:Vector.<int> = treeA.leafUpToDepth;
            var leafDepthsB:Vector.<int> = treeB.leafUpToDepth;
            var nodes:Vector.<int> = _nodes;
            var bounds:Vector.<Number> = _nodeBounds;
            var out:BestPair = _best;
            var visits:int = 1;
            var top:int = 1;
            out.limit = out.time = out.points.distance = Infinity;
            out.bound = 0;
            estimate(trees, 0, 0, out);
            nodes[0] = 0;
            nodes[1] = 0;
            bounds[0] = out.bound;
            while (top > 0 && out.limit > 0)
            {
                top--;
                var a:int = nodes[2 * top];
                var b:int = nodes[2 * top + 1];
                var bound:Number = bounds[top];
                if (!(bound < out.limit))
                {
                    continue;
                }
                var isLeafA:Boolean = leafDepthsA[a] >= trees.depthA;
                var isLeafB:Boolean = leafDepthsB[b] >= trees.depthB;
                if (isLeafA && isLeafB)
                {
                    measure(trees, a, b, kernel, out);
                    continue;
                }
                var dividesA:Boolean = trees.dividesA(a, isLeafA, b, isLeafB);
                var leftA:int = dividesA ? treeA.left[a] : a;
                var leftB:int = dividesA ? b : treeB.left[b];
                var rightA:int = dividesA ? leftA + 1 : a;
                var rightB:int = dividesA ? b : leftB + 1;
                out.bound = bound;
                estimate(trees, leftA, leftB, out);
                var leftBound:Number = out.bound;
                out.bound = bound;
                estimate(trees, rightA, rightB, out);
                var rightBound:Number = out.bound;
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

        /** Sets <code>out.bound</code> for a pair of nodes. A bound that is not less than <code>out.limit</code> need not be exact. */
        protected function estimate(trees:TreePair, a:int, b:int, out:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement estimate");
        }

        /** Measures two leaves, by the kernel, or by their boxes if it is null. If they are better than the best pair so far, they become it. */
        protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel, out:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement measure");
        }
    }
}
