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
     * are apart. Whether two standing trees overlap needs no bounds: see BoxTraversal.</p>
     *
     * @private
     */
    public class NodePairTraversal
    {
        // The best pair, and the bounds of the search.
        private var _bounds:NodePairBounds = new NodePairBounds();

        // The pairs of nodes still to visit, and their bounds.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodeBounds:Vector.<Number> = new Vector.<Number>();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function NodePairTraversal(counts:TreeCounts)
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
         * @param decider decides about such nodes; null if their boxes decide
         * @return the best pair; the next search overwrites it
         */
        protected final function find(pose:RelativePose, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int, decider:NodePairSearch):NodePairBounds
        {
            var leftA:Vector.<int> = treeA.left;
            var leftB:Vector.<int> = treeB.left;
            var stopA:Vector.<int> = treeA.stop;
            var stopB:Vector.<int> = treeB.stop;
            var a:int = 0;
            var b:int = 0;
            var stack:Vector.<int> = _nodes;
            var out:NodePairBounds = _bounds;
            var stackBounds:Vector.<Number> = _nodeBounds;
            var scale:Number = pose.placement.size;
            var top:int = 0;
            var visits:int = 1;
            out.least = out.points.distance = Infinity;
            out.current = 0;
            estimate(pose, treeA, a, treeB, b, out);
            while (true)
            {
                if (out.current < out.least)
                {
                    var aEnds:Boolean = stopA[a] >= depthA;
                    var bEnds:Boolean = stopB[b] >= depthB;
                    if (!aEnds || !bEnds)
                    {
                        // The better of the two pairs with a child comes first.
                        var dividesA:Boolean = bEnds || !aEnds && isLarger(treeA.boxes, 6 * a, treeB.boxes, 6 * b, scale);
                        var otherA:int = dividesA ? leftA[a] : a;
                        var otherB:int = dividesA ? b : leftB[b];
                        a = dividesA ? otherA + 1 : a;
                        b = dividesA ? b : otherB + 1;
                        var above:Number = out.current;
                        estimate(pose, treeA, otherA, treeB, otherB, out);
                        var other:Number = out.current;
                        out.current = above;
                        estimate(pose, treeA, a, treeB, b, out);
                        visits += 2;
                        if (other < out.current)
                        {
                            var node:int = a;
                            a = otherA;
                            otherA = node;
                            node = b;
                            b = otherB;
                            otherB = node;
                            above = out.current;
                            out.current = other;
                            other = above;
                        }
                        if (other < out.least)
                        {
                            stack[2 * top] = otherA;
                            stack[2 * top + 1] = otherB;
                            stackBounds[top] = other;
                            top++;
                        }
                        continue;
                    }
                    settle(pose, treeA, a, treeB, b, decider, out);
                    if (out.current < out.least)
                    {
                        out.least = out.current;
                        out.nodeA = a;
                        out.nodeB = b;
                    }
                }
                if (top == 0 || !(out.least > 0))
                {
                    _counts.nodeVisits += visits;
                    return out;
                }
                top--;
                a = stack[2 * top];
                b = stack[2 * top + 1];
                out.current = stackBounds[top];
            }
            return out;
        }

        // Whether the sphere around a box is at least as large as the sphere around another one, whose numbers are scaled.
        private static function isLarger(boxesA:Vector.<Number>, a:int, boxesB:Vector.<Number>, b:int, scale:Number):Boolean
        {
            var aX:Number = boxesA[int(a + 3)];
            var aY:Number = boxesA[int(a + 4)];
            var aZ:Number = boxesA[int(a + 5)];
            var bX:Number = boxesB[int(b + 3)];
            var bY:Number = boxesB[int(b + 4)];
            var bZ:Number = boxesB[int(b + 5)];
            return aX * aX + aY * aY + aZ * aZ >= scale * scale * (bX * bX + bY * bY + bZ * bZ);
        }

        /** Sets <code>out.current</code> for a pair of nodes. A bound that is not less than <code>out.least</code> need not be exact. */
        protected function estimate(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:NodePairBounds):void
        {
            throw new IllegalOperationError(this + " does not implement estimate");
        }

        /**
         * Sets <code>out.current</code> to the time or distance of a pair that decides. If it is less than <code>out.least</code>, also sets what
         * <code>out</code> has of the best pair. Otherwise it need not be exact.
         */
        protected function settle(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, decider:NodePairSearch, out:NodePairBounds):void
        {
            throw new IllegalOperationError(this + " does not implement settle");
        }
    }
}
