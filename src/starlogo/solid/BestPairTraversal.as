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
     * are apart. The subclass keeps the best pair. Whether two standing trees overlap needs no bounds: see OverlapTraversal.</p>
     *
     * <p>The limit and the bound are fields, because JavaScript engines allocate an object for each Number that functions pass.</p>
     */
    internal class BestPairTraversal
    {
        /** No larger time or distance counts: that of the best pair so far, or Infinity. */
        protected var limit:Number = Infinity;

        /** No part of the pair of nodes that is estimated has a smaller time or distance. Before it is estimated, the bound of its parent pair. */
        protected var bound:Number = 0;

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
         * Visits the pairs of leaves (see BoxTree) that may be the best one. A subclass calls it when all is set that does not depend on the nodes.
         *
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them
         */
        protected final function visitPairs(trees:TreePair, kernel:TrianglePairKernel):void
        {
            var treeA:BoxTree = trees.a;
            var treeB:BoxTree = trees.b;
            var leafDepthsA:Vector.<int> = treeA.leafUpToDepth;
            var leafDepthsB:Vector.<int> = treeB.leafUpToDepth;
            var nodes:Vector.<int> = _nodes;
            var bounds:Vector.<Number> = _nodeBounds;
            var visits:int = 1;
            var top:int = 1;
            limit = Infinity;
            bound = 0;
            estimate(trees, 0, 0);
            nodes[0] = 0;
            nodes[1] = 0;
            bounds[0] = bound;
            while (top > 0 && limit > 0)
            {
                top--;
                var a:int = nodes[2 * top];
                var b:int = nodes[2 * top + 1];
                var parentBound:Number = bounds[top];
                if (!(parentBound < limit))
                {
                    continue;
                }
                var isLeafA:Boolean = leafDepthsA[a] >= trees.depthA;
                var isLeafB:Boolean = leafDepthsB[b] >= trees.depthB;
                if (isLeafA && isLeafB)
                {
                    measure(trees, a, b, kernel);
                    continue;
                }
                var dividesA:Boolean = trees.dividesA(a, isLeafA, b, isLeafB);
                var leftA:int = dividesA ? treeA.left[a] : a;
                var leftB:int = dividesA ? b : treeB.left[b];
                var rightA:int = dividesA ? leftA + 1 : a;
                var rightB:int = dividesA ? b : leftB + 1;
                bound = parentBound;
                estimate(trees, leftA, leftB);
                var leftBound:Number = bound;
                bound = parentBound;
                estimate(trees, rightA, rightB);
                var rightBound:Number = bound;
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
        }

        /** Sets the bound of a pair of nodes. A bound that is not less than the limit need not be exact. */
        protected function estimate(trees:TreePair, a:int, b:int):void
        {
            throw new IllegalOperationError(this + " does not implement estimate");
        }

        /**
         * Measures two leaves: their triangles by the kernel, if the trees are exact, otherwise their boxes. If they are better than the best pair so far,
         * they become it.
         */
        protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):void
        {
            throw new IllegalOperationError(this + " does not implement measure");
        }
    }
}
