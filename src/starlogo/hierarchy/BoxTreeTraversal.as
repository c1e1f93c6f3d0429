package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Decides whether two trees of boxes overlap, whichever way their models are turned, or a tree and a single box.
     *
     * <p>In the space of the first model the first's boxes are axis-aligned and the second's all turned alike: a pair of
     * boxes takes a few products (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996; Ericson, "Real-Time Collision
     * Detection", §4.4.1). Of two nodes that overlap the larger is divided, and the child that is nearer to the other node
     * is looked at first. The axes of the edges are tried only where the boxes decide: higher up, what they would separate
     * is mostly separated by the next boxes (van den Bergen, "Efficient collision detection of complex deformable models
     * using AABB trees", 1997).</p>
     */
    internal final class BoxTreeTraversal
    {
        /** Pairs of nodes that were visited; HierarchyTraversal sets it to 0. */
        public var nodeVisits:int = 0;

        /** Whether the roots overlapped of two trees that do not. */
        public var rootsOverlapped:Boolean;

        private var _pose:RelativePose;
        private var _edges:EdgeAxes = new EdgeAxes();
        private var _stack:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function BoxTreeTraversal(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Whether two nodes that are leaves or at their depth limit overlap.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param exact decides in place of such nodes that overlap, or null
         */
        public function overlap(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, exact:ExactPairTest):Boolean
        {
            // the inner loop of every frame: all is in locals, and nothing is called but where boxes decide
            var relative:Placement = _pose.placement;
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
            var touching:Number = _pose.gap;
            var edgesAreReady:Boolean = false;
            var stack:Vector.<HierarchyNode> = _stack;
            var top:int = 0;
            var visits:int = 0;
            while (true)
            {
                visits++;

                // from the middle of a's box to that of b's
                var bX:Number = b.x;
                var bY:Number = b.y;
                var bZ:Number = b.z;
                var x:Number = m00 * bX + m01 * bY + m02 * bZ + moveX - a.x;
                var y:Number = m10 * bX + m11 * bY + m12 * bZ + moveY - a.y;
                var z:Number = m20 * bX + m21 * bY + m22 * bZ + moveZ - a.z;

                // how far b's middle is outside of a, against the spheres around b and inside of it
                var halfX:Number = a.halfX + touching;
                var halfY:Number = a.halfY + touching;
                var halfZ:Number = a.halfZ + touching;
                var gapSquared:Number = 0;
                var gap:Number = x < 0 ? -x : x;
                gap -= halfX;
                if (gap > 0)
                {
                    gapSquared = gap * gap;
                }
                gap = y < 0 ? -y : y;
                gap -= halfY;
                if (gap > 0)
                {
                    gapSquared += gap * gap;
                }
                gap = z < 0 ? -z : z;
                gap -= halfZ;
                if (gap > 0)
                {
                    gapSquared += gap * gap;
                }
                var overlap:Boolean = false;
                var isDeep:Boolean = false;
                var reach:Number = scale * b.radius;
                if (gapSquared <= reach * reach)
                {
                    reach = scale * b.innerRadius;
                    if (gapSquared <= reach * reach)
                    {
                        overlap = isDeep = true;
                    }
                    else
                    {
                        // the faces of a, then those of b; all of b's times the scale
                        bX = b.halfX;
                        bY = b.halfY;
                        bZ = b.halfZ;
                        reach = halfX + abs00 * bX + abs01 * bY + abs02 * bZ;
                        if (x <= reach && x >= -reach)
                        {
                            reach = halfY + abs10 * bX + abs11 * bY + abs12 * bZ;
                            if (y <= reach && y >= -reach)
                            {
                                reach = halfZ + abs20 * bX + abs21 * bY + abs22 * bZ;
                                if (z <= reach && z >= -reach)
                                {
                                    var along:Number = m00 * x + m10 * y + m20 * z;
                                    reach = scaleSquared * bX + abs00 * halfX + abs10 * halfY + abs20 * halfZ;
                                    if (along <= reach && along >= -reach)
                                    {
                                        along = m01 * x + m11 * y + m21 * z;
                                        reach = scaleSquared * bY + abs01 * halfX + abs11 * halfY + abs21 * halfZ;
                                        if (along <= reach && along >= -reach)
                                        {
                                            along = m02 * x + m12 * y + m22 * z;
                                            reach = scaleSquared * bZ + abs02 * halfX + abs12 * halfY + abs22 * halfZ;
                                            overlap = along <= reach && along >= -reach;
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
                if (overlap)
                {
                    var aEnds:Boolean = a.cutoffLevel >= depthA;
                    var bEnds:Boolean = b.cutoffLevel >= depthB;
                    var axis:int;
                    if (aEnds && bEnds)
                    {
                        if (exact != null)
                        {
                            if (exact.leavesTouch(a, b))
                            {
                                nodeVisits += visits;
                                return true;
                            }
                        }
                        else if (isDeep)
                        {
                            nodeVisits += visits;
                            return true;
                        }
                        else
                        {
                            if (!edgesAreReady)
                            {
                                edgesAreReady = true;
                                _edges.prepare(_pose);
                            }
                            if (!_edges.separate(a, b, x, y, z))
                            {
                                nodeVisits += visits;
                                return true;
                            }
                        }
                    }
                    else if (isDeep && !aEnds && !bEnds)
                    {
                        // a child of a most likely overlaps b too: both are divided at once
                        axis = a.splitAxis;
                        var near:HierarchyNode = a.left;
                        stack[top] = a.right;
                        var side:Number = z;
                        if (axis == 0)
                        {
                            side = x;
                        }
                        else if (axis == 1)
                        {
                            side = y;
                        }
                        if (side > 0)
                        {
                            stack[top] = near;
                            near = a.right;
                        }
                        stack[int(top + 1)] = b;
                        x += a.x - near.x;
                        y += a.y - near.y;
                        z += a.z - near.z;
                        a = near;
                        axis = b.splitAxis;
                        stack[int(top + 2)] = a;
                        if (axis == 0)
                        {
                            side = m00 * x + m10 * y + m20 * z;
                        }
                        else if (axis == 1)
                        {
                            side = m01 * x + m11 * y + m21 * z;
                        }
                        else
                        {
                            side = m02 * x + m12 * y + m22 * z;
                        }
                        if (side < 0)
                        {
                            stack[int(top + 3)] = b.left;
                            b = b.right;
                        }
                        else
                        {
                            stack[int(top + 3)] = b.right;
                            b = b.left;
                        }
                        top += 4;
                        continue;
                    }
                    else if (bEnds || (!aEnds && a.radius >= scale * b.radius))
                    {
                        // the child on the side where b is
                        axis = a.splitAxis;
                        side = z;
                        if (axis == 0)
                        {
                            side = x;
                        }
                        else if (axis == 1)
                        {
                            side = y;
                        }
                        if (side > 0)
                        {
                            stack[top] = a.left;
                            a = a.right;
                        }
                        else
                        {
                            stack[top] = a.right;
                            a = a.left;
                        }
                        stack[int(top + 1)] = b;
                        top += 2;
                        continue;
                    }
                    else
                    {
                        axis = b.splitAxis;
                        stack[top] = a;
                        if (axis == 0)
                        {
                            side = m00 * x + m10 * y + m20 * z;
                        }
                        else if (axis == 1)
                        {
                            side = m01 * x + m11 * y + m21 * z;
                        }
                        else
                        {
                            side = m02 * x + m12 * y + m22 * z;
                        }
                        if (side < 0)
                        {
                            stack[int(top + 1)] = b.left;
                            b = b.right;
                        }
                        else
                        {
                            stack[int(top + 1)] = b.right;
                            b = b.left;
                        }
                        top += 2;
                        continue;
                    }
                }
                if (top == 0)
                {
                    nodeVisits += visits;
                    rootsOverlapped = visits > 1;
                    return false;
                }
                top -= 2;
                a = stack[top];
                b = stack[int(top + 1)];
            }
            return false;
        }
    }
}
