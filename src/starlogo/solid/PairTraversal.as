package starlogo.solid
{
    import flash.errors.IllegalOperationError;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.boxes.BoxPair;

    /**
     * Visits pairs of nodes of two trees, depth-first (thesis §4.6). A node's box encloses its children's boxes. So if the boxes of a pair rule out an
     * answer, the pair is skipped with all below it. Otherwise the larger node is divided. If the boxes of leaves are tested and two nodes overlap deeply,
     * both are divided, as in §6.3.4 of the thesis. The child nearer to the other node is visited first.
     *
     * <p>Each question has a subclass, which keeps the best answer so far: whether two standing trees overlap, when two moving trees first touch, how far
     * two trees are apart. This is branch and bound (Larsen, Gottschalk, Lin and Manocha, "Fast proximity queries with swept sphere volumes", 1999).</p>
     */
    internal class PairTraversal
    {
        // The pairs of nodes still to visit. The next one is last.
        private var _nodes:Vector.<int> = new Vector.<int>();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function PairTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Visits the pairs of nodes, down to the pairs of leaves (see BoxTree).
         *
         * @param pair has the rotation of tree b. It is set to the boxes of each pair
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them
         * @return whether the roots' boxes did not rule out an answer
         */
        protected final function visitPairs(trees:TreePair, pair:BoxPair, kernel:TrianglePairKernel):Boolean
        {
            var leafDepthsA:Vector.<int> = trees.a.leafUpToDepth;
            var leafDepthsB:Vector.<int> = trees.b.leafUpToDepth;
            var depthA:int = trees.depthA;
            var depthB:int = trees.depthB;
            var isExact:Boolean = trees.isExact;
            var nodes:Vector.<int> = _nodes;
            var isAnyPossible:Boolean = false;
            var visits:int = 0;
            var top:int = 2;
            nodes[0] = 0;
            nodes[1] = 0;
            while (top > 0)
            {
                top -= 2;
                var a:int = nodes[top];
                var b:int = nodes[top + 1];
                var isLeafA:Boolean = leafDepthsA[a] >= depthA;
                var isLeafB:Boolean = leafDepthsB[b] >= depthB;
                visits++;
                trees.readBoxes(a, b, pair);
                if (!isPossible(trees, pair, isLeafA && isLeafB && !isExact))
                {
                    continue;
                }
                isAnyPossible = true;
                if (!isLeafA || !isLeafB)
                {
                    top = pushChildren(trees, pair, a, isLeafA, b, isLeafB, !isExact && isDeep(pair), top);
                }
                else if (measure(trees, a, b, kernel))
                {
                    break;
                }
            }
            _counts.nodeVisits += visits;
            return isAnyPossible;
        }

        /**
         * Whether the boxes of two nodes leave an answer possible that is better than the best so far.
         *
         * @param pair the boxes. The subclass may enlarge them, or move b's. Where they are afterwards decides which children are near each other
         * @param areTested whether the boxes are those of leaves whose boxes decide
         */
        protected function isPossible(trees:TreePair, pair:BoxPair, areTested:Boolean):Boolean
        {
            throw new IllegalOperationError(this + " does not implement isPossible");
        }

        /**
         * Measures two leaves: their triangles by the kernel, if the trees are exact, otherwise their boxes. Keeps the answer if it is the best so far.
         *
         * @return whether nothing can be better
         */
        protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):Boolean
        {
            throw new IllegalOperationError(this + " does not implement measure");
        }

        // Puts the children of one node or of both in place of the pair, so that the nearest pair is visited first. Returns the new top of the stack.
        private function pushChildren(trees:TreePair, pair:BoxPair, a:int, isLeafA:Boolean, b:int, isLeafB:Boolean, dividesBoth:Boolean, top:int):int
        {
            var nodes:Vector.<int> = _nodes;
            var dividesA:Boolean = !isLeafA && (dividesBoth || isLeafB || isALarger(pair));
            var dividesB:Boolean = !isLeafB && (dividesBoth || !dividesA);
            var nearer:int;
            if (dividesA)
            {
                nearer = nearerChildOfA(pair, trees.a, a);
                // the other child: the numbers of both add up to 2 * left + 1
                nodes[top] = 2 * trees.a.left[a] + 1 - nearer;
                nodes[top + 1] = b;
                top += 2;
                a = nearer;
            }
            if (dividesB)
            {
                nearer = nearerChildOfB(pair, trees.b, b);
                nodes[top] = a;
                nodes[top + 1] = 2 * trees.b.left[b] + 1 - nearer;
                top += 2;
                b = nearer;
            }
            nodes[top] = a;
            nodes[top + 1] = b;
            return top + 2;
        }

        // Whether a's box is at least as large as b's, by the spheres around them.
        private static function isALarger(pair:BoxPair):Boolean
        {
            return pair.aHalfX * pair.aHalfX + pair.aHalfY * pair.aHalfY + pair.aHalfZ * pair.aHalfZ
                >= pair.bHalfX * pair.bHalfX + pair.bHalfY * pair.bHalfY + pair.bHalfZ * pair.bHalfZ;
        }

        // Whether the middle of b's box is so near to a's box that all of b's own axes overlap.
        private static function isDeep(pair:BoxPair):Boolean
        {
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var halfX:Number = pair.aHalfX;
            var halfY:Number = pair.aHalfY;
            var halfZ:Number = pair.aHalfZ;
            include "../geometry/squaredToBox.inc";
            var least:Number = pair.bHalfX < pair.bHalfY ? pair.bHalfX : pair.bHalfY;
            least = pair.bHalfZ < least ? pair.bHalfZ : least;
            return squaredDistance <= least * least;
        }

        // Returns the child of a node of tree a that is nearer to b's node.
        private static function nearerChildOfA(pair:BoxPair, tree:BoxTree, node:int):int
        {
            var axis:int = tree.axisOf(node);
            var along:Number = axis == 0 ? pair.offsetX : (axis == 1 ? pair.offsetY : pair.offsetZ);
            return along > 0 ? tree.left[node] + 1 : tree.left[node];
        }

        // Returns the child of a node of tree b that is nearer to a's node.
        private static function nearerChildOfB(pair:BoxPair, tree:BoxTree, node:int):int
        {
            var rotation:Placement = pair.rotation;
            var axis:int = tree.axisOf(node);
            var along:Number = rotation.r02 * pair.offsetX + rotation.r12 * pair.offsetY + rotation.r22 * pair.offsetZ;
            if (axis == 0)
            {
                along = rotation.r00 * pair.offsetX + rotation.r10 * pair.offsetY + rotation.r20 * pair.offsetZ;
            }
            else if (axis == 1)
            {
                along = rotation.r01 * pair.offsetX + rotation.r11 * pair.offsetY + rotation.r21 * pair.offsetZ;
            }
            return along < 0 ? tree.left[node] + 1 : tree.left[node];
        }
    }
}
