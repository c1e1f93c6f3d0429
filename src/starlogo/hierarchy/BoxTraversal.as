package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Decides whether two standing trees overlap. It is like NodePairTraversal, but without bounds, because each pair overlaps
     * or not.
     *
     * <p>In the first model's space, its own boxes are axis-aligned, and all boxes of the second have the same rotation. So a pair of boxes
     * takes a few products (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", §4.4.1). If
     * two nodes overlap, the larger one is divided, or both if the overlap is deep. The child nearer to the other node is visited first.</p>
     *
     * <p>The axes of the edges are tried only for pairs whose boxes decide. Higher up, the next boxes separate most of what these axes would
     * separate (van den Bergen, "Efficient collision detection of complex deformable models using AABB trees", 1997).</p>
     *
     * @private
     */
    public final class BoxTraversal
    {
        /** Whether the roots overlapped in the last search, if it has found nothing. */
        public var rootsOverlapped:Boolean = false;

        // The pairs of nodes still to visit.
        private var _nodes:Vector.<int> = new Vector.<int>();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function BoxTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Whether two nodes that decide overlap: see BoxTree.
         *
         * <p>The steps for a pair are: the faces of a, each with the vector from the middle of a's box to the middle of b's box along it (x, y, z);
         * the distance of b's middle from a, compared with the spheres around b and inside of it; the faces of b; and if the boxes decide, the
         * nine pairs of edges. A face of a separates most pairs, mostly its top or bottom, so the other steps take little time.</p>
         *
         * <p>The entries of b's rotation (m00 ...) and their absolute values (abs00 ...) contain b's scale. b's half-extents (bX ...) do not, except
         * for the edges. The absolute values are larger by a rounding error, because cross products of nearly parallel edges cancel.</p>
         *
         * <p>The method is long because a pair takes less time than a few calls: all values are locals, and only the test of two nodes and the axis
         * of a node are calls.</p>
         *
         * @param pose the pose of the second tree's nodes in the first model's space
         * @param treeA the first tree
         * @param depthA how many of its levels are visited
         * @param treeB the second tree
         * @param depthB how many of its levels are visited
         * @param decider decides about such nodes; null if their boxes decide
         */
        public function find(pose:RelativePose, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int, decider:NodePairTest):Boolean
        {
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var widened:Number = Tolerances.ROUNDING * scale;
            var m00:Number = relative.r00 * scale;
            var m01:Number = relative.r01 * scale;
            var m02:Number = relative.r02 * scale;
            var m10:Number = relative.r10 * scale;
            var m11:Number = relative.r11 * scale;
            var m12:Number = relative.r12 * scale;
            var m20:Number = relative.r20 * scale;
            var m21:Number = relative.r21 * scale;
            var m22:Number = relative.r22 * scale;
            var abs00:Number = m00 < 0 ? widened - m00 : widened + m00;
            var abs01:Number = m01 < 0 ? widened - m01 : widened + m01;
            var abs02:Number = m02 < 0 ? widened - m02 : widened + m02;
            var abs10:Number = m10 < 0 ? widened - m10 : widened + m10;
            var abs11:Number = m11 < 0 ? widened - m11 : widened + m11;
            var abs12:Number = m12 < 0 ? widened - m12 : widened + m12;
            var abs20:Number = m20 < 0 ? widened - m20 : widened + m20;
            var abs21:Number = m21 < 0 ? widened - m21 : widened + m21;
            var abs22:Number = m22 < 0 ? widened - m22 : widened + m22;
            var scaleSquared:Number = scale * scale;
            var tolerance:Number = pose.tolerance;
            var boxesA:Vector.<Number> = treeA.boxes;
            var boxesB:Vector.<Number> = treeB.boxes;
            var stopA:Vector.<int> = treeA.stop;
            var stopB:Vector.<int> = treeB.stop;
            var stack:Vector.<int> = _nodes;
            var a:int = 0;
            var b:int = 0;
            var top:int = 0;
            var visits:int = 0;
            while (true)
            {
                visits++;

                var atA:int = 6 * a;
                var atB:int = 6 * b;
                var middleX:Number = boxesB[atB];
                var middleY:Number = boxesB[int(atB + 1)];
                var middleZ:Number = boxesB[int(atB + 2)];
                var bX:Number = boxesB[int(atB + 3)];
                var bY:Number = boxesB[int(atB + 4)];
                var bZ:Number = boxesB[int(atB + 5)];
                var overlap:Boolean = false;
                var isDeep:Boolean = false;
                var x:Number = 0;
                var y:Number = 0;
                var halfX:Number = 0;
                var halfY:Number = 0;
                var squaredRadius:Number = 0;

                var z:Number = m20 * middleX + m21 * middleY + m22 * middleZ + moveZ - boxesA[int(atA + 2)];
                var halfZ:Number = boxesA[int(atA + 5)] + tolerance;
                var radius:Number = halfZ + abs20 * bX + abs21 * bY + abs22 * bZ;
                if (z <= radius && z >= -radius)
                {
                    x = m00 * middleX + m01 * middleY + m02 * middleZ + moveX - boxesA[atA];
                    halfX = boxesA[int(atA + 3)] + tolerance;
                    radius = halfX + abs00 * bX + abs01 * bY + abs02 * bZ;
                    if (x <= radius && x >= -radius)
                    {
                        y = m10 * middleX + m11 * middleY + m12 * middleZ + moveY - boxesA[int(atA + 1)];
                        halfY = boxesA[int(atA + 4)] + tolerance;
                        radius = halfY + abs10 * bX + abs11 * bY + abs12 * bZ;
                        if (y <= radius && y >= -radius)
                        {
                            include "../intersection/squaredToBox.inc";
                            squaredRadius = scaleSquared * (bX * bX + bY * bY + bZ * bZ);
                            radius = bX < bY ? bX : bY;
                            radius = bZ < radius ? bZ : radius;
                            isDeep = squaredDistance <= scaleSquared * radius * radius;
                            overlap = isDeep;
                            if (!isDeep && squaredDistance <= squaredRadius)
                            {
                                var along:Number = m00 * x + m10 * y + m20 * z;
                                radius = scaleSquared * bX + abs00 * halfX + abs10 * halfY + abs20 * halfZ;
                                if (along <= radius && along >= -radius)
                                {
                                    along = m01 * x + m11 * y + m21 * z;
                                    radius = scaleSquared * bY + abs01 * halfX + abs11 * halfY + abs21 * halfZ;
                                    if (along <= radius && along >= -radius)
                                    {
                                        along = m02 * x + m12 * y + m22 * z;
                                        radius = scaleSquared * bZ + abs02 * halfX + abs12 * halfY + abs22 * halfZ;
                                        overlap = along <= radius && along >= -radius;
                                        if (overlap && decider == null && stopA[a] >= depthA && stopB[b] >= depthB)
                                        {
                                            bX *= scale;
                                            bY *= scale;
                                            bZ *= scale;
                                            include "../intersection/boxEdges.inc";
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
                if (overlap)
                {
                    var aEnds:Boolean = stopA[a] >= depthA;
                    var bEnds:Boolean = stopB[b] >= depthB;
                    if (aEnds && bEnds)
                    {
                        if (decider == null || decider.areTouching(treeA, a, treeB, b))
                        {
                            _counts.nodeVisits += visits;
                            return true;
                        }
                    }
                    else
                    {
                        var axis:int;
                        var side:Number;
                        var child:int;
                        var dividesA:Boolean = !aEnds && (bEnds || isDeep || halfX * halfX + halfY * halfY + halfZ * halfZ >= squaredRadius);
                        if (dividesA)
                        {
                            axis = treeA.axisOf(a);
                            side = axis == 0 ? x : (axis == 1 ? y : z);
                            child = treeA.left[a];
                            a = side > 0 ? child + 1 : child;
                            stack[top] = 2 * child + 1 - a;
                            stack[top + 1] = b;
                            top += 2;
                            x += boxesA[atA] - boxesA[int(6 * a)];
                            y += boxesA[int(atA + 1)] - boxesA[int(6 * a + 1)];
                            z += boxesA[int(atA + 2)] - boxesA[int(6 * a + 2)];
                        }
                        if (isDeep ? !bEnds : !dividesA)
                        {
                            axis = treeB.axisOf(b);
                            side = axis == 0 ? m00 * x + m10 * y + m20 * z : (axis == 1 ? m01 * x + m11 * y + m21 * z : m02 * x + m12 * y + m22 * z);
                            child = treeB.left[b];
                            b = side < 0 ? child + 1 : child;
                            stack[top] = a;
                            stack[top + 1] = 2 * child + 1 - b;
                            top += 2;
                        }
                        continue;
                    }
                }
                if (top == 0)
                {
                    _counts.nodeVisits += visits;
                    rootsOverlapped = overlap || visits > 1;
                    return false;
                }
                top -= 2;
                a = stack[top];
                b = stack[top + 1];
            }
            return false;
        }
    }
}
