package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.ray.Ray;

    /**
     * Finds the leaves of a tree, visited to a depth (see BoxTree), that an axis-aligned box may meet while it moves (<code>nextMet()</code>), or that are
     * near it (<code>nextNear()</code>). Of two children the nearer one comes first. A ray is a box without extents. A box that stands has a motion of
     * length 0. The asker sets the box, begins, and takes one leaf after the other until there is none. Who begins again forgets the search before.
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

        // How much larger nodes are on each side, as a fraction of the tree's radius and of the box's half-extents: a little more than
        // sqrt(2.2e-16), where 2.2e-16 is a Number's rounding error. A line at a distance d from the middle of a sphere of radius r enters it
        // sqrt(r * r - d * d) before its nearest point. If d is nearly r, rounding changes that by up to sqrt(2.2e-16) r. So the test of a node may
        // find a touch so much before the box meets the node.
        // Smaller: such a touch may be missed. Larger: nodes are tested in vain.
        private static const SLACK:Number = 1.5e-8;

        /**
         * How far the search goes: a time of the motion, a distance along the ray, or a distance from the box. An asker that has found something makes it
         * less, so that only better leaves follow.
         */
        public var limit:Number = 0;

        // The middle of the box at time 0, and half of its extents.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _halfX:Number = 0;
        private var _halfY:Number = 0;
        private var _halfZ:Number = 0;

        // 1 divided by the motion along each axis, and the earliest time that counts.
        private var _inverseX:Number = STILL;
        private var _inverseY:Number = STILL;
        private var _inverseZ:Number = STILL;
        private var _earliest:Number = 0;

        private var _tree:BoxTree = null;
        private var _depth:int = 0;
        private var _slack:Number = 0;

        // The nodes that wait, the next one last; when the box meets them, or how far it is from them; and how many they are.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _enters:Vector.<Number> = new Vector.<Number>();
        private var _top:int = 0;

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
         */
        public function setExtents(extents:Vector.<Number>):void
        {
            _x = (extents[0] + extents[1]) / 2;
            _y = (extents[2] + extents[3]) / 2;
            _z = (extents[4] + extents[5]) / 2;
            _halfX = (extents[1] - extents[0]) / 2;
            _halfY = (extents[3] - extents[2]) / 2;
            _halfZ = (extents[5] - extents[4]) / 2;
        }

        /** Begins with the leaves that the box may meet on a motion, until its latest time. @param depth how many levels of the tree are visited */
        public function beginMet(tree:BoxTree, depth:int, motion:RelativeMotion):void
        {
            limit = motion.latestTime;
            _inverseX = inverseOf(motion.x);
            _inverseY = inverseOf(motion.y);
            _inverseZ = inverseOf(motion.z);
            _earliest = 0;
            begin(tree, depth);
        }

        /** Begins with the leaves that a ray may meet. No box is set before. @param depth how many levels of the tree are visited */
        public function beginAlong(tree:BoxTree, depth:int, ray:Ray):void
        {
            setCube(ray.origin.x, ray.origin.y, ray.origin.z, 0);
            limit = ray.to;
            _inverseX = inverseOf(ray.direction.x);
            _inverseY = inverseOf(ray.direction.y);
            _inverseZ = inverseOf(ray.direction.z);
            _earliest = ray.from;
            begin(tree, depth);
        }

        /**
         * Begins with the nodes without children that the box may meet on an endless way along an axis.
         *
         * @param axis 0, 1 or 2
         * @param sign 1, or -1 towards the smaller coordinates
         */
        public function beginAlongAxis(tree:BoxTree, axis:int, sign:int):void
        {
            limit = Infinity;
            _inverseX = axis == 0 ? sign : STILL;
            _inverseY = axis == 1 ? sign : STILL;
            _inverseZ = axis == 2 ? sign : STILL;
            _earliest = 0;
            begin(tree, BoxTree.EXACT);
        }

        /** Begins with the leaves near the standing box: all of them, until the asker lowers the limit. @param depth how many levels of the tree are visited */
        public function beginNear(tree:BoxTree, depth:int):void
        {
            limit = Infinity;
            begin(tree, depth);
        }

        private function begin(tree:BoxTree, depth:int):void
        {
            _tree = tree;
            _depth = depth;
            _slack = SLACK * (tree.boundingRadius + _halfX + _halfY + _halfZ);
            _nodes[0] = 0;
            _enters[0] = -Infinity;
            _top = 1;
        }

        private static function inverseOf(motion:Number):Number
        {
            return Math.max(-STILL, Math.min(STILL, 1 / motion));
        }

        /** The next leaf that the box may meet within the limit; -1 if there is none. The root is visited untested. */
        public function nextMet():int
        {
            var isStill:Boolean = Math.abs(_inverseX) == STILL && Math.abs(_inverseY) == STILL && Math.abs(_inverseZ) == STILL;
            return isStill ? nextOverlapped() : nextEntered();
        }

        // Of two children that a moving box enters, the one that it enters earlier is next, and the other one waits. The times along the axes are compared
        // in pairs, which decides most children along the first axis or the second. There is no call for each child, because calls take long in Adobe's VM.
        private function nextEntered():int
        {
            var tree:BoxTree = _tree;
            var boxes:Vector.<Number> = tree.boxes;
            var lefts:Vector.<int> = tree.left;
            var fromX:Number = _x;
            var fromY:Number = _y;
            var fromZ:Number = _z;
            var widerX:Number = _halfX + _slack;
            var widerY:Number = _halfY + _slack;
            var widerZ:Number = _halfZ + _slack;
            var inverseX:Number = _inverseX;
            var inverseY:Number = _inverseY;
            var inverseZ:Number = _inverseZ;
            var absX:Number = inverseX < 0 ? -inverseX : inverseX;
            var absY:Number = inverseY < 0 ? -inverseY : inverseY;
            var absZ:Number = inverseZ < 0 ? -inverseZ : inverseZ;
            var earliest:Number = _earliest;
            var latest:Number = limit < LATEST ? limit : LATEST;
            var node:int = nextWaiting(latest);
            var left:int = node < 0 ? 0 : lefts[node];
            while (node >= 0 && !visit(node, left))
            {
                // of the children that are met, the one to visit next, its left child, and when it is entered
                var next:int = -1;
                var leftOfNext:int = 0;
                var enterNext:Number = Infinity;
                for (var child:int = left; child < left + 2; child++)
                {
                    // read early, so that a processor waits for the memory of this and of the box at the same time
                    var leftOfChild:int = lefts[child];
                    // A box is met unless the moving box enters it along one axis after it has left it along another one.
                    var at:int = 6 * child;
                    var middle:Number = (boxes[at] - fromX) * inverseX;
                    var half:Number = (boxes[int(at + 3)] + widerX) * absX;
                    var enterX:Number = middle - half;
                    var leaveX:Number = middle + half;
                    if (enterX > latest || leaveX < earliest)
                    {
                        continue;
                    }
                    middle = (boxes[int(at + 1)] - fromY) * inverseY;
                    half = (boxes[int(at + 4)] + widerY) * absY;
                    var enterY:Number = middle - half;
                    var leaveY:Number = middle + half;
                    if (enterY > latest || leaveY < earliest || enterY > leaveX || leaveY < enterX)
                    {
                        continue;
                    }
                    middle = (boxes[int(at + 2)] - fromZ) * inverseZ;
                    half = (boxes[int(at + 5)] + widerZ) * absZ;
                    var enterZ:Number = middle - half;
                    var leaveZ:Number = middle + half;
                    if (enterZ > latest || leaveZ < earliest || enterZ > leaveX || leaveZ < enterX || enterZ > leaveY || leaveZ < enterY)
                    {
                        continue;
                    }
                    var enter:Number = enterX > earliest ? enterX : earliest;
                    enter = enterY > enter ? enterY : enter;
                    enter = enterZ > enter ? enterZ : enter;
                    if (enter >= enterNext)
                    {
                        _nodes[_top] = child;
                        _enters[_top++] = enter;
                        continue;
                    }
                    if (next >= 0)
                    {
                        _nodes[_top] = next;
                        _enters[_top++] = enterNext;
                    }
                    next = child;
                    leftOfNext = leftOfChild;
                    enterNext = enter;
                }
                node = next < 0 ? nextWaiting(latest) : next;
                left = next < 0 && node >= 0 ? lefts[node] : leftOfNext;
            }
            return node;
        }

        // Of two children that a standing box overlaps, the one that is nearer to its middle is next, and the other one waits.
        private function nextOverlapped():int
        {
            var node:int = nextWaiting(limit);
            while (node >= 0 && !visit(node, _tree.left[node]))
            {
                var left:int = _tree.left[node];
                var overlapsRight:Boolean = overlaps(left + 1);
                if (!overlaps(left))
                {
                    node = overlapsRight ? left + 1 : nextWaiting(limit);
                    continue;
                }
                var isRightNext:Boolean = overlapsRight && isRightNearer(_tree, node);
                if (overlapsRight)
                {
                    _nodes[_top] = isRightNext ? left : left + 1;
                    _enters[_top++] = _earliest;
                }
                node = isRightNext ? left + 1 : left;
            }
            return node;
        }

        // Takes the next node that waits and is entered within the limit; -1 if there is none.
        private function nextWaiting(latest:Number):int
        {
            while (_top > 0)
            {
                _top--;
                if (_enters[_top] <= latest)
                {
                    return _nodes[_top];
                }
            }
            return -1;
        }

        // Visits a node with a left child, or 0. Returns whether it is a leaf.
        private function visit(node:int, left:int):Boolean
        {
            _counts.nodeVisits++;
            // an exact search reads one list less
            return _depth == BoxTree.EXACT ? left == 0 : _tree.leafUpToDepth[node] >= _depth;
        }

        // Whether the standing box overlaps that of a node.
        private function overlaps(node:int):Boolean
        {
            var boxes:Vector.<Number> = _tree.boxes;
            var at:int = 6 * node;
            return Math.abs(boxes[at] - _x) <= boxes[int(at + 3)] + _halfX + _slack
                && Math.abs(boxes[int(at + 1)] - _y) <= boxes[int(at + 4)] + _halfY + _slack
                && Math.abs(boxes[int(at + 2)] - _z) <= boxes[int(at + 5)] + _halfZ + _slack;
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

        /** The next leaf near the standing box, within the limit; -1 if there is none. */
        public function nextNear():int
        {
            var tree:BoxTree = _tree;
            var nodes:Vector.<int> = _nodes;
            var distances:Vector.<Number> = _enters;
            var top:int = _top;
            // nothing is nearer than 0
            while (top > 0 && limit > 0)
            {
                top--;
                var node:int = nodes[top];
                if (distances[top] > limit)
                {
                    continue;
                }
                _counts.nodeVisits++;
                if (tree.leafUpToDepth[node] >= _depth)
                {
                    _top = top;
                    return node;
                }
                node = tree.left[node];
                nodes[top] = node;
                nodes[int(top + 1)] = node + 1;
                writeDistance(tree.boxes, 6 * node, distances, top);
                writeDistance(tree.boxes, 6 * node + 6, distances, top + 1);
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
            return -1;
        }

        // Writes how far the box is from the box of a node, less the slack.
        private function writeDistance(boxes:Vector.<Number>, at:int, out:Vector.<Number>, to:int):void
        {
            var distanceX:Number = Math.max(0, Math.abs(boxes[at] - _x) - boxes[int(at + 3)] - _halfX);
            var distanceY:Number = Math.max(0, Math.abs(boxes[int(at + 1)] - _y) - boxes[int(at + 4)] - _halfY);
            var distanceZ:Number = Math.max(0, Math.abs(boxes[int(at + 2)] - _z) - boxes[int(at + 5)] - _halfZ);
            out[to] = Math.sqrt(distanceX * distanceX + distanceY * distanceY + distanceZ * distanceZ) - _slack;
        }
    }
}
