package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Decides whether two standing trees overlap. It is like BestPairTraversal, but without bounds, because each pair overlaps
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

        // The vector from the middle of the first tree's node to that of the second's.
        private var _between:Vector3D = new Vector3D();

        private var _counts:TreeCounts;

        /** @param counts counts the pairs of nodes that are visited */
        public function OverlapTraversal(counts:TreeCounts)
        {
            _counts = counts;
        }

        /**
         * Finds whether two nodes that decide touch: see BoxTree.
         *
         * <p>The steps for a pair are: the faces of a, each with the vector from the middle of a's box to the middle of b's box along it (z, x, y);
         * the distance of b's middle from a, compared with the spheres around b and inside of it; the faces of b; and if the boxes decide, the
         * nine pairs of edges. A face of a separates most pairs, mostly its top or bottom, so the other steps take little time.</p>
         *
         * <p>The entries of b's rotation (m00 ...) and their absolute values (abs00 ...) contain b's scale. b's half-extents (bX ...) do not, except
         * for the edges. The absolute values are larger by a rounding error, because cross products of nearly parallel edges cancel.</p>
         *
         * <p>The test of two boxes stands in the loop, because it takes less time than a few calls: all of its values are locals.</p>
         *
         * @param pose the pose of the second tree's nodes in the first model's space
         * @param treeA the first tree
         * @param depthA how many of its levels are visited
         * @param treeB the second tree
         * @param depthB how many of its levels are visited
         * @param visitor decides about such nodes; null if their boxes decide
         * @return APART, ONLY_ROOTS or OVERLAPPING
         */
        public function find(pose:RelativePose, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int, visitor:OverlapVisitor):int
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
            var endsA:Vector.<int> = treeA.endsUpToDepth;
            var endsB:Vector.<int> = treeB.endsUpToDepth;
            var stack:Vector.<int> = _nodes;
            var result:int = APART;
            var visits:int = 0;
            var top:int = 2;
            stack[0] = 0;
            stack[1] = 0;
            while (top > 0 && result != OVERLAPPING)
            {
                top -= 2;
                var a:int = stack[top];
                var b:int = stack[top + 1];
                visits++;

                var atA:int = 6 * a;
                var atB:int = 6 * b;
                var middleX:Number = boxesB[atB];
                var middleY:Number = boxesB[int(atB + 1)];
                var middleZ:Number = boxesB[int(atB + 2)];
                var bX:Number = boxesB[int(atB + 3)];
                var bY:Number = boxesB[int(atB + 4)];
                var bZ:Number = boxesB[int(atB + 5)];

                var z:Number = m20 * middleX + m21 * middleY + m22 * middleZ + moveZ - boxesA[int(atA + 2)];
                var halfZ:Number = boxesA[int(atA + 5)] + tolerance;
                var radius:Number = halfZ + abs20 * bX + abs21 * bY + abs22 * bZ;
                if (z > radius || z < -radius)
                {
                    continue;
                }
                var x:Number = m00 * middleX + m01 * middleY + m02 * middleZ + moveX - boxesA[atA];
                var halfX:Number = boxesA[int(atA + 3)] + tolerance;
                radius = halfX + abs00 * bX + abs01 * bY + abs02 * bZ;
                if (x > radius || x < -radius)
                {
                    continue;
                }
                var y:Number = m10 * middleX + m11 * middleY + m12 * middleZ + moveY - boxesA[int(atA + 1)];
                var halfY:Number = boxesA[int(atA + 4)] + tolerance;
                radius = halfY + abs10 * bX + abs11 * bY + abs12 * bZ;
                if (y > radius || y < -radius)
                {
                    continue;
                }

                include "../intersection/squaredToBox.inc";
                var squaredRadius:Number = scaleSquared * (bX * bX + bY * bY + bZ * bZ);
                if (squaredDistance > squaredRadius)
                {
                    continue;
                }
                radius = bX < bY ? bX : bY;
                radius = bZ < radius ? bZ : radius;
                var isDeep:Boolean = squaredDistance <= scaleSquared * radius * radius;
                var aEnds:Boolean = endsA[a] >= depthA;
                var bEnds:Boolean = endsB[b] >= depthB;
                if (!isDeep)
                {
                    var along:Number = m00 * x + m10 * y + m20 * z;
                    radius = scaleSquared * bX + abs00 * halfX + abs10 * halfY + abs20 * halfZ;
                    var overlap:Boolean = along <= radius && along >= -radius;
                    if (overlap)
                    {
                        along = m01 * x + m11 * y + m21 * z;
                        radius = scaleSquared * bY + abs01 * halfX + abs11 * halfY + abs21 * halfZ;
                        overlap = along <= radius && along >= -radius;
                    }
                    if (overlap)
                    {
                        along = m02 * x + m12 * y + m22 * z;
                        radius = scaleSquared * bZ + abs02 * halfX + abs12 * halfY + abs22 * halfZ;
                        overlap = along <= radius && along >= -radius;
                    }
                    if (overlap && visitor == null && aEnds && bEnds)
                    {
                        bX *= scale;
                        bY *= scale;
                        bZ *= scale;
                        include "../intersection/boxEdges.inc";
                    }
                    if (!overlap)
                    {
                        continue;
                    }
                }

                result = ONLY_ROOTS;
                if (!aEnds || !bEnds)
                {
                    var isLarger:Boolean = halfX * halfX + halfY * halfY + halfZ * halfZ >= squaredRadius;
                    var dividesA:Boolean = !aEnds && (bEnds || isDeep || isLarger);
                    var nearer:int;
                    _between.setTo(x, y, z);
                    if (dividesA)
                    {
                        nearer = nearerChildOfA(treeA, a);
                        stack[top] = 2 * treeA.left[a] + 1 - nearer;
                        stack[top + 1] = b;
                        top += 2;
                        a = nearer;
                    }
                    if (isDeep ? !bEnds : !dividesA)
                    {
                        nearer = nearerChildOfB(relative, treeB, b);
                        stack[top] = a;
                        stack[top + 1] = 2 * treeB.left[b] + 1 - nearer;
                        top += 2;
                        b = nearer;
                    }
                    stack[top] = a;
                    stack[top + 1] = b;
                    top += 2;
                }
                else if (visitor == null || visitor.areTouching(treeA, a, treeB, b))
                {
                    result = OVERLAPPING;
                }
            }
            _counts.nodeVisits += visits;
            return result;
        }

        // Returns the child of a node of the first tree that is nearer to the second one's node. _between then begins at this child.
        private function nearerChildOfA(tree:BoxTree, node:int):int
        {
            var between:Vector3D = _between;
            var axis:int = tree.axisOf(node);
            var child:int = tree.left[node];
            var along:Number = axis == 0 ? between.x : (axis == 1 ? between.y : between.z);
            if (along > 0)
            {
                child++;
            }
            var boxes:Vector.<Number> = tree.boxes;
            var from:int = 6 * node;
            var to:int = 6 * child;
            between.x += boxes[from] - boxes[to];
            between.y += boxes[int(from + 1)] - boxes[int(to + 1)];
            between.z += boxes[int(from + 2)] - boxes[int(to + 2)];
            return child;
        }

        // Returns the child of a node of the second tree that is nearer to the first one's node.
        private function nearerChildOfB(rotation:Placement, tree:BoxTree, node:int):int
        {
            var between:Vector3D = _between;
            var axis:int = tree.axisOf(node);
            var along:Number = rotation.r02 * between.x + rotation.r12 * between.y + rotation.r22 * between.z;
            if (axis == 0)
            {
                along = rotation.r00 * between.x + rotation.r10 * between.y + rotation.r20 * between.z;
            }
            else if (axis == 1)
            {
                along = rotation.r01 * between.x + rotation.r11 * between.y + rotation.r21 * between.z;
            }
            return along < 0 ? tree.left[node] + 1 : tree.left[node];
        }
    }
}
