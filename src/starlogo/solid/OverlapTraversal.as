package starlogo.solid
{
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.boxes.BoxPair;
    import starlogo.intersection.boxes.BoxSeparation;

    /**
     * Decides whether two standing trees overlap. It is like BestPairTraversal, but without bounds, because each pair overlaps
     * or not.
     *
     * <p>In the space of tree a, its own boxes are axis-aligned, and all boxes of tree b have the same rotation. So a pair of boxes
     * takes a few products (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", §4.4.1). If
     * two nodes overlap, the larger one is divided. If the boxes of leaves are tested and the overlap is deep, both are, as in §6.3.4 of the thesis. The
     * child nearer to the other node is visited first.</p>
     *
     * <p>The axes of the edges are tried only for pairs of leaves whose boxes are tested. Higher up, the next boxes separate most of what these axes would
     * separate (van den Bergen, "Efficient collision detection of complex deformable models using AABB trees", 1997).</p>
     *
     * @private
     */
    public final class OverlapTraversal
    {
        /** Result of <code>find()</code>: the roots are apart. */
        public static const APART:int = 0;

        /** Result of <code>find()</code>: the roots overlap, but no leaves touch. */
        public static const ONLY_ROOTS:int = 1;

        /** Result of <code>find()</code>: two leaves touch. */
        public static const OVERLAPPING:int = 2;

        // The pairs of nodes still to visit. The next one is last.
        private var _nodes:Vector.<int> = new Vector.<int>();

        // The rotation of tree b. Its absolute values are larger by a rounding error, because cross products of nearly parallel edges
        // cancel. And the vector from the middle of a's node to the middle of b's, of the last pair that was tested.
        private var _pair:BoxPair = new BoxPair();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function OverlapTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Finds whether two leaves touch: see BoxTree.
         *
         * @param kernel tests the triangles of two leaves, if the trees are exact. It has begun with them
         * @return APART, ONLY_ROOTS or OVERLAPPING
         */
        public function find(trees:TreePair, kernel:TrianglePairKernel):int
        {
            var pair:BoxPair = _pair;
            var isExact:Boolean = trees.isExact;
            var margin:Number = trees.pose.margin;
            var leafDepthsA:Vector.<int> = trees.a.leafUpToDepth;
            var leafDepthsB:Vector.<int> = trees.b.leafUpToDepth;
            var depthA:int = trees.depthA;
            var depthB:int = trees.depthB;
            var nodes:Vector.<int> = _nodes;
            var result:int = APART;
            var visits:int = 0;
            var top:int = 2;
            pair.setRotation(trees.pose.placement, Tolerances.ROUNDING);
            nodes[0] = 0;
            nodes[1] = 0;
            while (top > 0 && result != OVERLAPPING)
            {
                top -= 2;
                var a:int = nodes[top];
                var b:int = nodes[top + 1];
                visits++;
                trees.readBoxes(a, b, pair);
                pair.halvesA[0] += margin;
                pair.halvesA[1] += margin;
                pair.halvesA[2] += margin;
                var isLeafA:Boolean = leafDepthsA[a] >= depthA;
                var isLeafB:Boolean = leafDepthsB[b] >= depthB;
                var areBoxesTested:Boolean = isLeafA && isLeafB && !isExact;
                if (!BoxSeparation.overlapAlongFacesOfA(pair) || !BoxSeparation.overlapAlongFacesOfB(pair)
                        || areBoxesTested && !BoxSeparation.overlapAcrossEdges(pair))
                {
                    continue;
                }
                result = ONLY_ROOTS;
                if (!isLeafA || !isLeafB)
                {
                    top = pushChildren(trees, a, isLeafA, b, isLeafB, !isExact && isDeep(pair), top);
                }
                else if (areBoxesTested || kernel.areTouching(a, b))
                {
                    result = OVERLAPPING;
                }
            }
            _counts.nodeVisits += visits;
            return result;
        }

        // Puts the children of one node or of both in place of the pair, so that the nearest pair is visited first. Returns the new top of the stack.
        private function pushChildren(trees:TreePair, a:int, isLeafA:Boolean, b:int, isLeafB:Boolean, dividesBoth:Boolean, top:int):int
        {
            var nodes:Vector.<int> = _nodes;
            var dividesA:Boolean = dividesBoth ? !isLeafA : trees.dividesA(a, isLeafA, b, isLeafB);
            var dividesB:Boolean = dividesBoth ? !isLeafB : !dividesA;
            var nearer:int;
            if (dividesA)
            {
                nearer = nearerChildOfA(_pair, trees.a, a);
                // the other child: the numbers of both add up to 2 * left + 1
                nodes[top] = 2 * trees.a.left[a] + 1 - nearer;
                nodes[top + 1] = b;
                top += 2;
                a = nearer;
            }
            if (dividesB)
            {
                nearer = nearerChildOfB(_pair, trees.b, b);
                nodes[top] = a;
                nodes[top + 1] = 2 * trees.b.left[b] + 1 - nearer;
                top += 2;
                b = nearer;
            }
            nodes[top] = a;
            nodes[top + 1] = b;
            return top + 2;
        }

        // Whether the middle of b's box is so near to a's box that all of b's own axes overlap.
        private static function isDeep(pair:BoxPair):Boolean
        {
            var x:Number = pair.offset[0];
            var y:Number = pair.offset[1];
            var z:Number = pair.offset[2];
            var halfX:Number = pair.halvesA[0];
            var halfY:Number = pair.halvesA[1];
            var halfZ:Number = pair.halvesA[2];
            include "../geometry/squaredToBox.inc";
            var halves:Vector.<Number> = pair.halvesB;
            var least:Number = halves[0] < halves[1] ? halves[0] : halves[1];
            least = halves[2] < least ? halves[2] : least;
            return squaredDistance <= least * least;
        }

        // Returns the child of a node of tree a that is nearer to b's node.
        private static function nearerChildOfA(pair:BoxPair, tree:BoxTree, node:int):int
        {
            return pair.offset[tree.axisOf(node)] > 0 ? tree.left[node] + 1 : tree.left[node];
        }

        // Returns the child of a node of tree b that is nearer to a's node.
        private static function nearerChildOfB(pair:BoxPair, tree:BoxTree, node:int):int
        {
            var axis:int = tree.axisOf(node);
            var rotation:Vector.<Number> = pair.rotation;
            var along:Number = rotation[axis] * pair.offset[0] + rotation[int(axis + 3)] * pair.offset[1] + rotation[int(axis + 6)] * pair.offset[2];
            return along < 0 ? tree.left[node] + 1 : tree.left[node];
        }
    }
}
