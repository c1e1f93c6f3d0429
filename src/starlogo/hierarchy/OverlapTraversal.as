package starlogo.hierarchy
{
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.boxes.BoxSeparation;
    import starlogo.intersection.boxes.BoxPair;

    /**
     * Decides whether two standing trees overlap. It is like BestPairTraversal, but without bounds, because each pair overlaps
     * or not.
     *
     * <p>In the space of tree a, its own boxes are axis-aligned, and all boxes of tree b have the same rotation. So a pair of boxes
     * takes a few products (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", §4.4.1). If
     * two nodes overlap, the larger one is divided. The child nearer to the other node is visited first.</p>
     *
     * <p>The axes of the edges are tried only for pairs whose boxes decide. Higher up, the next boxes separate most of what these axes would
     * separate (van den Bergen, "Efficient collision detection of complex deformable models using AABB trees", 1997).</p>
     *
     * @private
     */
    public final class OverlapTraversal
    {
        /** Result of <code>find()</code>: the roots are apart. */
        public static const APART:int = 0;

        /** Result of <code>find()</code>: the roots overlap, but no nodes that decide touch. */
        public static const ONLY_ROOTS:int = 1;

        /** Result of <code>find()</code>: two nodes that decide touch. */
        public static const OVERLAPPING:int = 2;

        // The pairs of nodes still to visit. The next one is last.
        private var _nodes:Vector.<int> = new Vector.<int>();

        // The axes of tree b. Their absolute values are larger by a rounding error, because cross products of nearly parallel edges
        // cancel. And the vector from the middle of a's node to the middle of b's, of the last pair that was tested.
        private var _pair:BoxPair = new BoxPair();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function OverlapTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Finds whether two nodes that decide touch: see BoxTree.
         *
         * @param kernel decides about such nodes; null if their boxes decide
         * @return APART, ONLY_ROOTS or OVERLAPPING
         */
        public function find(trees:PosedTrees, kernel:NodePairKernel):int
        {
            var pair:BoxPair = _pair;
            var tolerance:Number = trees.pose.tolerance;
            var endsA:Vector.<int> = trees.a.endsUpToDepth;
            var endsB:Vector.<int> = trees.b.endsUpToDepth;
            var depthA:int = trees.depthA;
            var depthB:int = trees.depthB;
            var stack:Vector.<int> = _nodes;
            var result:int = APART;
            var visits:int = 0;
            var top:int = 2;
            pair.axes.readAxes(trees.pose.placement, 1, Tolerances.ROUNDING);
            stack[0] = 0;
            stack[1] = 0;
            while (top > 0 && result != OVERLAPPING)
            {
                top -= 2;
                var a:int = stack[top];
                var b:int = stack[top + 1];
                visits++;
                trees.readPair(a, b, pair);
                pair.aHalfX += tolerance;
                pair.aHalfY += tolerance;
                pair.aHalfZ += tolerance;
                var aEnds:Boolean = endsA[a] >= depthA;
                var bEnds:Boolean = endsB[b] >= depthB;
                var doBoxesDecide:Boolean = aEnds && bEnds && kernel == null;
                if (!BoxSeparation.overlapAlongFacesOfA(pair) || !BoxSeparation.overlapAlongFacesOfB(pair)
                        || doBoxesDecide && !BoxSeparation.overlapAcrossEdges(pair))
                {
                    continue;
                }
                result = ONLY_ROOTS;
                if (!aEnds || !bEnds)
                {
                    top = pushChildren(trees, pair, a, aEnds, b, bEnds, top);
                }
                else if (doBoxesDecide || kernel.areTouching(a, b))
                {
                    result = OVERLAPPING;
                }
            }
            _counts.nodeVisits += visits;
            return result;
        }

        // Puts the pairs of a node with the children of the other, which is the larger one, in place of the pair. The nearer child is visited
        // first. Returns the new top of the stack.
        private function pushChildren(trees:PosedTrees, pair:BoxPair, a:int, aEnds:Boolean, b:int, bEnds:Boolean, top:int):int
        {
            var stack:Vector.<int> = _nodes;
            var dividesA:Boolean = !aEnds && (bEnds || trees.isNodeALarger(a, b));
            var left:int = dividesA ? trees.a.left[a] : trees.b.left[b];
            var isRightNearer:Boolean = dividesA
                ? isRightNearerOfA(pair, trees.a.axisOf(a))
                : isRightNearerOfB(pair, trees.pose.placement, trees.b.axisOf(b));
            var nearer:int = isRightNearer ? left + 1 : left;
            var farther:int = isRightNearer ? left : left + 1;
            stack[top] = dividesA ? farther : a;
            stack[top + 1] = dividesA ? b : farther;
            stack[top + 2] = dividesA ? nearer : a;
            stack[top + 3] = dividesA ? b : nearer;
            return top + 4;
        }

        // Whether the distance of b's middle from a's box shows that the boxes are apart.
        private static function isBeyondSphereOfB(pair:BoxPair):Boolean
        {
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var halfX:Number = pair.aHalfX;
            var halfY:Number = pair.aHalfY;
            var halfZ:Number = pair.aHalfZ;
            include "../intersection/squaredToBox.inc";
            return squaredDistance > pair.bHalfX * pair.bHalfX + pair.bHalfY * pair.bHalfY + pair.bHalfZ * pair.bHalfZ;
        }

        // Whether the right child of a's node is nearer to b's node.
        private static function isRightNearerOfA(pair:BoxPair, axis:int):Boolean
        {
            var along:Number = axis == 0 ? pair.offsetX : (axis == 1 ? pair.offsetY : pair.offsetZ);
            return along > 0;
        }

        // Whether the right child of b's node is nearer to a's node.
        private static function isRightNearerOfB(pair:BoxPair, rotation:Placement, axis:int):Boolean
        {
            var along:Number = rotation.r02 * pair.offsetX + rotation.r12 * pair.offsetY + rotation.r22 * pair.offsetZ;
            if (axis == 0)
            {
                along = rotation.r00 * pair.offsetX + rotation.r10 * pair.offsetY + rotation.r20 * pair.offsetZ;
            }
            else if (axis == 1)
            {
                along = rotation.r01 * pair.offsetX + rotation.r11 * pair.offsetY + rotation.r21 * pair.offsetZ;
            }
            return along < 0;
        }
    }
}
