package starlogo.hierarchy
{
    import starlogo.intersection.TriangleTest;

    /**
     * Finds the leaves of a hierarchy of triangles that an axis-aligned box may meet on its way, the nearer of two children first. A ray is
     * a box without extents. A box that stands has no motion.
     *
     * <p>A place on the way is a multiple of the motion. The box meets a node between two places on each axis (Kay and Kajiya, "Ray tracing
     * complex scenes", SIGGRAPH 1986).</p>
     *
     * @private
     */
    public final class MovingBoxTraversal
    {
        // 1 divided by the least motion: a smaller one counts as 0. No way is longer than FARTHEST. Larger numbers might be infinite.
        private static const SLOWEST:Number = 1e100;
        private static const FARTHEST:Number = 1e90;

        // How much larger boxes are on each side because of rounding, as a fraction of the tree's radius.
        private static const MARGIN:Number = 1.5e-8;

        /** The number of nodes visited. The caller sets it to 0. */
        public var nodeVisits:int = 0;

        /** The middle of the box at place 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Half of the box's extents. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;

        /** The place where the way begins. */
        public var from:Number = 0;

        // The motion.
        private var _motionX:Number = 0;
        private var _motionY:Number = 0;
        private var _motionZ:Number = 0;

        // The nodes still to visit, and where the box meets them.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _enters:Vector.<Number> = new Vector.<Number>();

        /** Sets the box's middle, and half of its extent along each axis. */
        public function setPlace(x:Number, y:Number, z:Number, half:Number):void
        {
            this.x = x;
            this.y = y;
            this.z = z;
            halfX = halfY = halfZ = half;
        }

        /** Sets the motion; 0 if the box stands. */
        public function setMotion(x:Number, y:Number, z:Number):void
        {
            _motionX = x;
            _motionY = y;
            _motionZ = z;
        }

        /** Sets a motion along an axis. @param axis 0, 1 or 2 @param side 1, or -1 towards the smaller coordinates */
        public function setAxis(axis:int, side:int):void
        {
            setMotion(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0);
        }

        /**
         * Lets a test look at the leaves.
         *
         * @param tree a tree of triangles
         * @param test its <code>least</code> must be the place where the way ends; 0 if the box stands
         */
        public function find(tree:BoxTree, test:TriangleTest):void
        {
            var margin:Number = MARGIN * tree.radius;
            var fromX:Number = x;
            var fromY:Number = y;
            var fromZ:Number = z;
            var widerX:Number = halfX + margin;
            var widerY:Number = halfY + margin;
            var widerZ:Number = halfZ + margin;
            var inverseX:Number = 1 / _motionX;
            var inverseY:Number = 1 / _motionY;
            var inverseZ:Number = 1 / _motionZ;
            inverseX = inverseX > -SLOWEST && inverseX < SLOWEST ? inverseX : SLOWEST;
            inverseY = inverseY > -SLOWEST && inverseY < SLOWEST ? inverseY : SLOWEST;
            inverseZ = inverseZ > -SLOWEST && inverseZ < SLOWEST ? inverseZ : SLOWEST;
            var absX:Number = inverseX < 0 ? -inverseX : inverseX;
            var absY:Number = inverseY < 0 ? -inverseY : inverseY;
            var absZ:Number = inverseZ < 0 ? -inverseZ : inverseZ;
            var boxes:Vector.<Number> = tree.boxes;
            var children:Vector.<int> = tree.low;
            var nodes:Vector.<int> = _nodes;
            var enters:Vector.<Number> = _enters;
            var begin:Number = from;
            var limit:Number = test.least < FARTHEST ? test.least : FARTHEST;
            var stands:Boolean = _motionX == 0 && _motionY == 0 && _motionZ == 0;
            var visits:int = 0;
            var top:int = 0;
            var node:int = 0;
            while (true)
            {
                visits++;
                var low:int = children[node];
                if (low == 0)
                {
                    test.look(tree.first[node], tree.end[node]);
                    limit = test.least < limit ? test.least : limit;
                }
                else
                {
                    var at:int = 6 * low;
                    var middle:Number;
                    var half:Number;
                    var place:Number;
                    var enter:Number = begin;
                    var leave:Number = limit;
                    middle = (boxes[at] - fromX) * inverseX;
                    half = (boxes[int(at + 3)] + widerX) * absX;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (boxes[int(at + 1)] - fromY) * inverseY;
                    half = (boxes[int(at + 4)] + widerY) * absY;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (boxes[int(at + 2)] - fromZ) * inverseZ;
                    half = (boxes[int(at + 5)] + widerZ) * absZ;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    var enterLow:Number = enter;
                    var leaveLow:Number = leave;
                    enter = begin;
                    leave = limit;
                    middle = (boxes[int(at + 6)] - fromX) * inverseX;
                    half = (boxes[int(at + 9)] + widerX) * absX;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (boxes[int(at + 7)] - fromY) * inverseY;
                    half = (boxes[int(at + 10)] + widerY) * absY;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (boxes[int(at + 8)] - fromZ) * inverseZ;
                    half = (boxes[int(at + 11)] + widerZ) * absZ;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    if (enterLow <= leaveLow)
                    {
                        if (enter > leave)
                        {
                            node = low;
                            continue;
                        }
                        var isHighFirst:Boolean = enter < enterLow;
                        if (stands)
                        {
                            place = 2 * fromZ - boxes[int(at + 8)] - boxes[int(at + 2)];
                            var axis:int = tree.axisOf(node);
                            if (axis == 0)
                            {
                                place = 2 * fromX - boxes[int(at + 6)] - boxes[at];
                            }
                            else if (axis == 1)
                            {
                                place = 2 * fromY - boxes[int(at + 7)] - boxes[int(at + 1)];
                            }
                            isHighFirst = place >= 0;
                        }
                        if (isHighFirst)
                        {
                            nodes[top] = low;
                            enters[top] = enterLow;
                            node = low + 1;
                        }
                        else
                        {
                            nodes[top] = low + 1;
                            enters[top] = enter;
                            node = low;
                        }
                        top++;
                        continue;
                    }
                    if (enter <= leave)
                    {
                        node = low + 1;
                        continue;
                    }
                }
                do
                {
                    if (top == 0)
                    {
                        nodeVisits += visits;
                        return;
                    }
                    top--;
                }
                while (enters[top] > limit);
                node = nodes[top];
            }
        }
    }
}
