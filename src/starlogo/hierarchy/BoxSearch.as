package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.ray.Ray;

    /**
     * Visits a tree, and calls a NodeVisitor for the leaves of the search (see BoxTree): those that an axis-aligned box may meet while it moves
     * (<code>visitMet()</code>), or those that are near it (<code>visitNear()</code>). The nearer of two children comes first. A ray is a box without
     * extents (<code>visitAlong()</code>). A box that stands has no motion.
     *
     * <p>A time is a multiple of the motion. The box meets a node between two times on each axis (Kay and Kajiya, "Ray tracing
     * complex scenes", SIGGRAPH 1986).</p>
     *
     * @private
     */
    public final class BoxSearch
    {
        // 1 divided by the motion along an axis along which the box stands, or moves by less than 1e-100. Infinity would make NaN of a distance of 0.
        private static const STILL:Number = 1e100;

        // The latest time that counts. It is less than the time at which a box that stands beside a node would meet it.
        private static const LATEST:Number = 1e90;

        // How much larger boxes are on each side, as a fraction of the tree's radius and of the half-extents of what moves: a little more than
        // sqrt(2.2e-16), where 2.2e-16 is a Number's rounding error. A line at a distance d from the middle of a sphere of radius r enters it
        // sqrt(r * r - d * d) before its nearest point. If d is nearly r, rounding changes that by up to sqrt(2.2e-16) r. So the test of a node may
        // find a touch so much before the box meets the node.
        // Smaller: such a touch may be missed. Larger: nodes are tested in vain.
        private static const SLACK:Number = 1.5e-8;

        // The middle of the box at time 0, and half of its extents.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _halfX:Number = 0;
        private var _halfY:Number = 0;
        private var _halfZ:Number = 0;

        // 1 divided by the motion along each axis, and the time from which on nodes count.
        private var _inverseX:Number = STILL;
        private var _inverseY:Number = STILL;
        private var _inverseZ:Number = STILL;
        private var _from:Number = 0;

        // The nodes still to visit, and where the box meets them, or how far it is from them.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _enters:Vector.<Number> = new Vector.<Number>();

        private var _counts:TreeCounts;

        /** @param counts counts the nodes that are visited; null if nobody asks */
        public function BoxSearch(counts:TreeCounts = null)
        {
            _counts = counts || new TreeCounts();
        }

        /** Sets the box to a cube: its middle, and half of its width. */
        public function setCube(x:Number, y:Number, z:Number, half:Number):void
        {
            _x = x;
            _y = y;
            _z = z;
            _halfX = _halfY = _halfZ = half;
        }

        /**
         * Sets the box to the extents of a structure.
         *
         * @param extents least x, greatest x, least y, ...
         * @param distance how much larger the box is on each side
         */
        public function setExtents(extents:Vector.<Number>, distance:Number):void
        {
            _x = (extents[0] + extents[1]) / 2;
            _y = (extents[2] + extents[3]) / 2;
            _z = (extents[4] + extents[5]) / 2;
            _halfX = (extents[1] - extents[0]) / 2 + distance;
            _halfY = (extents[3] - extents[2]) / 2 + distance;
            _halfZ = (extents[5] - extents[4]) / 2 + distance;
        }

        /** Sets the motion. */
        public function setMotion(motion:RelativeMotion):void
        {
            _inverseX = inverseOf(motion.x);
            _inverseY = inverseOf(motion.y);
            _inverseZ = inverseOf(motion.z);
            _from = 0;
        }

        /** Sets a motion along an axis. @param axis 0, 1 or 2 @param sign 1, or -1 towards the smaller coordinates */
        public function setAxis(axis:int, sign:int):void
        {
            _inverseX = axis == 0 ? sign : STILL;
            _inverseY = axis == 1 ? sign : STILL;
            _inverseZ = axis == 2 ? sign : STILL;
            _from = 0;
        }

        private static function inverseOf(motion:Number):Number
        {
            var inverse:Number = 1 / motion;
            if (inverse > -STILL && inverse < STILL)
            {
                return inverse;
            }
            return STILL;
        }

        /** Visits the nodes that a ray may meet. The visitor's limit must be set: the ray's end. */
        public function visitAlong(ray:Ray, tree:BoxTree, depth:int, visitor:NodeVisitor):void
        {
            setCube(ray.origin.x, ray.origin.y, ray.origin.z, 0);
            _inverseX = inverseOf(ray.direction.x);
            _inverseY = inverseOf(ray.direction.y);
            _inverseZ = inverseOf(ray.direction.z);
            _from = ray.from;
            visitMet(tree, depth, visitor);
        }

        /**
         * Visits the nodes that the box may meet during its motion. The root is visited untested. The child that is visited next does not pass the
         * stack. The times along the axes are compared in pairs, which decides most children along the first axis or the second. One function does
         * it all, because calls for each child take long in Adobe's VM.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param visitor its limit must be set: the latest time that counts
         */
        public function visitMet(tree:BoxTree, depth:int, visitor:NodeVisitor):void
        {
            var slack:Number = SLACK * (tree.boundingRadius + _halfX + _halfY + _halfZ);
            var fromX:Number = _x;
            var fromY:Number = _y;
            var fromZ:Number = _z;
            var widerX:Number = _halfX + slack;
            var widerY:Number = _halfY + slack;
            var widerZ:Number = _halfZ + slack;
            var inverseX:Number = _inverseX;
            var inverseY:Number = _inverseY;
            var inverseZ:Number = _inverseZ;
            var isStill:Boolean = inverseX == STILL && inverseY == STILL && inverseZ == STILL;
            var absX:Number = inverseX < 0 ? -inverseX : inverseX;
            var absY:Number = inverseY < 0 ? -inverseY : inverseY;
            var absZ:Number = inverseZ < 0 ? -inverseZ : inverseZ;
            var boxes:Vector.<Number> = tree.boxes;
            var children:Vector.<int> = tree.left;
            var ends:Vector.<int> = tree.leafUpToDepth;
            // An exact visit ends at the nodes without children. It need not read another column.
            var isLimited:Boolean = depth < BoxTree.EXACT;
            var nodes:Vector.<int> = _nodes;
            var enters:Vector.<Number> = _enters;
            var begin:Number = _from;
            var latest:Number = visitor.limit < LATEST ? visitor.limit : LATEST;
            var visits:int = 0;
            var top:int = 0;
            var node:int = 0;
            while (true)
            {
                visits++;
                var left:int = children[node];
                if (left == 0 || isLimited && ends[node] >= depth)
                {
                    visitor.visit(tree, node);
                    latest = visitor.limit < latest ? visitor.limit : latest;
                }
                else
                {
                    // of the children that are met, the one to visit next, and when it is entered
                    var next:int = -1;
                    var enterNext:Number = 0;
                    for (var child:int = left; child < left + 2; child++)
                    {
                        var at:int = 6 * child;
                        // A box is met unless the moving box enters it along one axis after it has left it along another one.
                        var middle:Number = (boxes[at] - fromX) * inverseX;
                        var half:Number = (boxes[int(at + 3)] + widerX) * absX;
                        var enterX:Number = middle - half;
                        var leaveX:Number = middle + half;
                        if (enterX > latest || leaveX < begin)
                        {
                            continue;
                        }
                        middle = (boxes[int(at + 1)] - fromY) * inverseY;
                        half = (boxes[int(at + 4)] + widerY) * absY;
                        var enterY:Number = middle - half;
                        var leaveY:Number = middle + half;
                        if (enterY > latest || leaveY < begin || enterY > leaveX || leaveY < enterX)
                        {
                            continue;
                        }
                        middle = (boxes[int(at + 2)] - fromZ) * inverseZ;
                        half = (boxes[int(at + 5)] + widerZ) * absZ;
                        var enterZ:Number = middle - half;
                        var leaveZ:Number = middle + half;
                        if (enterZ > latest || leaveZ < begin || enterZ > leaveX || leaveZ < enterX || enterZ > leaveY || leaveZ < enterY)
                        {
                            continue;
                        }
                        var enter:Number = enterX > begin ? enterX : begin;
                        enter = enterY > enter ? enterY : enter;
                        enter = enterZ > enter ? enterZ : enter;
                        if (next < 0)
                        {
                            // the first child that is met
                            next = child;
                            enterNext = enter;
                            continue;
                        }
                        // The nearer child is next, and the other one waits.
                        var isRightNext:Boolean = isStill ? isRightNearer(tree, node) : enter < enterNext;
                        nodes[top] = isRightNext ? next : child;
                        enters[top] = isRightNext ? enterNext : enter;
                        next = isRightNext ? child : next;
                        top++;
                    }
                    if (next >= 0)
                    {
                        // it does not pass the stack
                        node = next;
                        continue;
                    }
                }
                // The way down has ended: the last node that waits and still counts is next.
                top--;
                while (top >= 0 && enters[top] > latest)
                {
                    top--;
                }
                if (top < 0)
                {
                    break;
                }
                node = nodes[top];
            }
            _counts.nodeVisits += visits;
        }

        // Whether the box's middle is nearer to the right child of a node than to the left one, along the axis of their split.
        private function isRightNearer(tree:BoxTree, node:int):Boolean
        {
            var axis:int = tree.axisOf(node);
            var at:int = 6 * tree.left[node] + axis;
            var coordinate:Number = _z;
            if (axis == 0)
            {
                coordinate = _x;
            }
            else if (axis == 1)
            {
                coordinate = _y;
            }
            return 2 * coordinate - tree.boxes[int(at + 6)] - tree.boxes[at] >= 0;
        }

        /**
         * Visits the nodes that are near the standing box.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param visitor its limit must be set
         */
        public function visitNear(tree:BoxTree, depth:int, visitor:NodeVisitor):void
        {
            var nodes:Vector.<int> = _nodes;
            var distances:Vector.<Number> = _enters;
            var slack:Number = SLACK * tree.boundingRadius;
            var top:int = 1;
            nodes[0] = 0;
            distances[0] = 0;
            // nothing is nearer than 0
            while (top > 0 && visitor.limit > 0)
            {
                top--;
                var node:int = nodes[top];
                if (distances[top] > visitor.limit)
                {
                    continue;
                }
                _counts.nodeVisits++;
                if (tree.leafUpToDepth[node] >= depth)
                {
                    visitor.visit(tree, node);
                    continue;
                }
                node = tree.left[node];
                nodes[top] = node;
                nodes[int(top + 1)] = node + 1;
                writeDistance(tree.boxes, 6 * node, slack, distances, top);
                writeDistance(tree.boxes, 6 * node + 6, slack, distances, top + 1);
                if (distances[top] < distances[int(top + 1)])
                {
                    var distance:Number = distances[top];
                    distances[top] = distances[int(top + 1)];
                    distances[int(top + 1)] = distance;
                    nodes[top] = node + 1;
                    nodes[int(top + 1)] = node;
                }
                top += 2;
            }
        }

        // Writes how far the box is from the box of a node, less a slack.
        private function writeDistance(boxes:Vector.<Number>, at:int, slack:Number, out:Vector.<Number>, to:int):void
        {
            var distanceX:Number = Math.max(0, Math.abs(boxes[at] - _x) - boxes[int(at + 3)] - _halfX);
            var distanceY:Number = Math.max(0, Math.abs(boxes[int(at + 1)] - _y) - boxes[int(at + 4)] - _halfY);
            var distanceZ:Number = Math.max(0, Math.abs(boxes[int(at + 2)] - _z) - boxes[int(at + 5)] - _halfZ);
            out[to] = Math.sqrt(distanceX * distanceX + distanceY * distanceY + distanceZ * distanceZ) - slack;
        }
    }
}
