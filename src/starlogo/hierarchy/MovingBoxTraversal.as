package starlogo.hierarchy
{
    import starlogo.intersection.TriangleTest;

    /**
     * Finds the leaves of a hierarchy of triangles that an axis-aligned box may meet on its way, the nearer of two children first. A ray is
     * a box without extents. A box that stands has no motion.
     *
     * <p>A place on the way is a multiple of the motion. The box meets a node between two places on each axis (Kay and Kajiya, "Ray tracing
     * complex scenes", SIGGRAPH 1986). In the loop, all numbers are in steps of the tree's grid.</p>
     *
     * @private
     */
    public final class MovingBoxTraversal
    {
        // 1 divided by the least motion: a smaller one counts as 0. No way is longer than FARTHEST. Larger numbers might be infinite.
        private static const SLOWEST:Number = 1e100;
        private static const FARTHEST:Number = 1e90;

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

        // The pairs or leaves still to visit, and where the box meets them. The pair of a leaf is null.
        private var _pairs:Vector.<BoxPair> = new Vector.<BoxPair>();
        private var _leaves:Vector.<int> = new Vector.<int>();
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
         * @param tree the hierarchy, packed
         * @param test its <code>least</code> must be the place where the way ends; 0 if the box stands
         */
        public function find(tree:PackedTree, test:TriangleTest):void
        {
            var scale:Number = tree.scale;
            var fromX:Number = (x - tree.x) * scale;
            var fromY:Number = (y - tree.y) * scale;
            var fromZ:Number = (z - tree.z) * scale;
            var widerX:Number = halfX * scale;
            var widerY:Number = halfY * scale;
            var widerZ:Number = halfZ * scale;
            var inverseX:Number = 1 / (_motionX * scale);
            var inverseY:Number = 1 / (_motionY * scale);
            var inverseZ:Number = 1 / (_motionZ * scale);
            inverseX = inverseX > -SLOWEST && inverseX < SLOWEST ? inverseX : SLOWEST;
            inverseY = inverseY > -SLOWEST && inverseY < SLOWEST ? inverseY : SLOWEST;
            inverseZ = inverseZ > -SLOWEST && inverseZ < SLOWEST ? inverseZ : SLOWEST;
            var absX:Number = inverseX < 0 ? -inverseX : inverseX;
            var absY:Number = inverseY < 0 ? -inverseY : inverseY;
            var absZ:Number = inverseZ < 0 ? -inverseZ : inverseZ;
            var pairs:Vector.<BoxPair> = _pairs;
            var leaves:Vector.<int> = _leaves;
            var enters:Vector.<Number> = _enters;
            var begin:Number = from;
            var limit:Number = test.least < FARTHEST ? test.least : FARTHEST;
            var stands:Boolean = _motionX == 0 && _motionY == 0 && _motionZ == 0;
            var visits:int = 0;
            var top:int = 0;
            var pair:BoxPair = tree.root;
            var leaf:int = tree.rootLeaf;
            while (true)
            {
                visits++;
                if (pair == null)
                {
                    test.look(PackedTree.firstOf(leaf), PackedTree.endOf(leaf));
                    limit = test.least < limit ? test.least : limit;
                }
                else
                {
                    var middle:Number;
                    var half:Number;
                    var place:Number;
                    var enter:Number = begin;
                    var leave:Number = limit;
                    middle = (pair.lowX - fromX) * inverseX;
                    half = (pair.lowHalfX + widerX) * absX;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (pair.lowY - fromY) * inverseY;
                    half = (pair.lowHalfY + widerY) * absY;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (pair.lowZ - fromZ) * inverseZ;
                    half = (pair.lowHalfZ + widerZ) * absZ;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    var enterLow:Number = enter;
                    var leaveLow:Number = leave;
                    enter = begin;
                    leave = limit;
                    middle = (pair.highX - fromX) * inverseX;
                    half = (pair.highHalfX + widerX) * absX;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (pair.highY - fromY) * inverseY;
                    half = (pair.highHalfY + widerY) * absY;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    middle = (pair.highZ - fromZ) * inverseZ;
                    half = (pair.highHalfZ + widerZ) * absZ;
                    enter = middle - half > enter ? middle - half : enter;
                    leave = middle + half < leave ? middle + half : leave;
                    if (enterLow <= leaveLow)
                    {
                        if (enter > leave)
                        {
                            leaf = pair.lowLeaf;
                            pair = pair.low;
                            continue;
                        }
                        var isHighFirst:Boolean = enter < enterLow;
                        if (stands)
                        {
                            place = 2 * fromZ - pair.highZ - pair.lowZ;
                            if (pair.axis == 0)
                            {
                                place = 2 * fromX - pair.highX - pair.lowX;
                            }
                            else if (pair.axis == 1)
                            {
                                place = 2 * fromY - pair.highY - pair.lowY;
                            }
                            isHighFirst = place >= 0;
                        }
                        if (isHighFirst)
                        {
                            pairs[top] = pair.low;
                            leaves[top] = pair.lowLeaf;
                            enters[top] = enterLow;
                            leaf = pair.highLeaf;
                            pair = pair.high;
                        }
                        else
                        {
                            pairs[top] = pair.high;
                            leaves[top] = pair.highLeaf;
                            enters[top] = enter;
                            leaf = pair.lowLeaf;
                            pair = pair.low;
                        }
                        top++;
                        continue;
                    }
                    if (enter <= leave)
                    {
                        leaf = pair.highLeaf;
                        pair = pair.high;
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
                pair = pairs[top];
                leaf = leaves[top];
            }
        }
    }
}
