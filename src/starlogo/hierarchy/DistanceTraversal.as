package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;

    use namespace engine;

    /**
     * Finds how far two trees are apart: branch and bound, depth-first, the nearer of two pairs first (Larsen, Gottschalk, Lin and Manocha, "Fast
     * proximity queries with swept sphere volumes", 1999). Two nodes that are leaves or at their depth limit count; a pair of which all that is
     * below is no nearer than what was found is left out.
     *
     * <p>Nested: a distance is never greater than that of greater depths, and of what is in the leaves, to the last bit. Nodes are a little wider
     * than those below them (Tolerances.NESTING), which makes up for the rounding of what is near; for that of what is far their distance is taken
     * for a little less, the less the deeper they are.</p>
     *
     * <p>This one is for any structures: a pair is as far apart as its ancestors are, at least, as in a StructureTraversal. BoxDistances has another
     * way for boxes.</p>
     *
     * @private
     */
    public class DistanceTraversal
    {
        /** The least distance that was found, in the space of the first model. */
        public var least:Number;

        /** Pairs of nodes that were visited; set to 0 from outside. */
        public var nodeVisits:int = 0;

        /** Where the second model is in the space of the first. */
        protected var pose:RelativePose;

        /** How far both models reach from their middles: what rounding is relative to. */
        protected var reach:Number;

        /** What all below the pair under way is apart, at least; before estimate, that of the pair above. */
        protected var bound:Number;

        /** From the first model's point to the second's of the least distance so far. */
        protected var directionX:Number;

        /** @copy #directionX */
        protected var directionY:Number;

        /** @copy #directionX */
        protected var directionZ:Number;

        /** How far the last pair measured is apart, or a little less. */
        protected var measured:Number;

        // The pair that decides about the bound of the one under way: that pair, or one above; and the one that decides about the least distance.
        private var _decidingA:HierarchyNode;
        private var _decidingB:HierarchyNode;
        private var _nearestA:HierarchyNode;
        private var _nearestB:HierarchyNode;

        private var _pair:NodePair;
        private var _points:ClosestPair = new ClosestPair();

        // Pairs that are left, each with the one that decides about its bound.
        private var _count:int;
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _bounds:Vector.<Number> = new Vector.<Number>();

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function DistanceTraversal(pose:RelativePose)
        {
            this.pose = pose;
            _pair = new NodePair(pose);
        }

        /**
         * Finds the least distance (<code>least</code>) of two nodes that are leaves or at their depth limit.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param leaves finds the distance of such nodes; null if that of their structures counts
         */
        public final function find(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, leaves:LeafDistance):void
        {
            var nodes:Vector.<HierarchyNode> = _nodes;
            least = Infinity;
            reach = a.radius + b.radius * pose.placement.size;
            _pair.begin();
            begin();
            _count = 0;
            directionX = directionY = directionZ = 0;
            bound = 0;
            _decidingA = a;
            _decidingB = b;
            estimate(a, b);
            push(a, b, bound, _decidingA, _decidingB);
            while (_count > 0 && least > 0)
            {
                _count--;
                var top:int = 4 * _count;
                bound = _bounds[_count];
                if (bound >= least)
                {
                    continue;
                }
                nodeVisits++;
                a = nodes[top];
                b = nodes[top + 1];
                _decidingA = nodes[top + 2];
                _decidingB = nodes[top + 3];
                var aEnds:Boolean = a.cutoffLevel >= depthA;
                var bEnds:Boolean = b.cutoffLevel >= depthB;
                if (!aEnds || !bEnds)
                {
                    divide(a, b, bEnds || !aEnds && dividesFirst(a, b));
                }
                else if (leaves != null)
                {
                    leaves.add(a, b);
                    least = leaves.least;
                    directionX = leaves.x;
                    directionY = leaves.y;
                    directionZ = leaves.z;
                }
                else
                {
                    settle(a, b);
                    if (bound < least)
                    {
                        least = bound;
                        _nearestA = _decidingA;
                        _nearestB = _decidingB;
                        directionX = _points.bX - _points.aX;
                        directionY = _points.bY - _points.aY;
                        directionZ = _points.bZ - _points.aZ;
                    }
                }
            }
        }

        /** How far a structure reaches from its middle, or a little farther: what the rounding of distances is relative to. */
        public static function reachOf(structure:BoundingStructure):Number
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    return Sphere(structure).radius;
                case BoundingStructure.BOX:
                    var box:Box = Box(structure);
                    return box.halfX + box.halfY + box.halfZ;
                default:
                    var capsule:Capsule = Capsule(structure);
                    var start:Vector3D = capsule.start;
                    var end:Vector3D = capsule.end;
                    return capsule.radius + Math.abs(end.x - start.x) + Math.abs(end.y - start.y) + Math.abs(end.z - start.z);
            }
        }

        /** Writes the least distance and the closest points of the nodes that decided, in the space of the first model; not for leaves. */
        public final function writePoints(out:ClosestPair):void
        {
            _pair.begin();
            _pair.place(_nearestA, _nearestB);
            findClosest(_pair.a, _pair.b, out);
            out.distance = least;
        }

        /** Prepares for two models that the pose relates. */
        protected function begin():void
        {
        }

        /** Raises the bound to what a pair is apart at least, if that is more. */
        protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
            measure(a, b);
            raise(a, b);
        }

        /** Whether of two nodes the first is divided: level by level, so that answers are nested whatever the depths. */
        protected function dividesFirst(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return a.level <= b.level;
        }

        /** Sets the bound of a pair that is not divided to how far it is apart. */
        protected function settle(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /** Finds how far the structures of two nodes are apart. */
        protected final function measure(a:HierarchyNode, b:HierarchyNode):void
        {
            _pair.place(a, b);
            findClosest(_pair.a, _pair.b, _points);
            var distance:Number = _points.distance;
            measured = distance - Tolerances.NESTING * (levelsBelow(a) + levelsBelow(b)) * (distance + reach);
            if (!(measured > 0))
            {
                measured = 0;
            }
        }

        /** Raises the bound to what was measured of a pair, if that is more. */
        protected final function raise(a:HierarchyNode, b:HierarchyNode):void
        {
            if (measured >= bound)
            {
                bound = measured;
                _decidingA = a;
                _decidingB = b;
            }
        }

        // How many levels there may be below a node, and one; that of a single structure is the last.
        private static function levelsBelow(node:HierarchyNode):int
        {
            var level:int = node.level;
            return level == 0 || level > Tolerances.NESTED_LEVELS ? 1 : 1 + Tolerances.NESTED_LEVELS - level;
        }

        // Puts a node's children, each with the other node, on the stack: the nearer one on top.
        private function divide(a:HierarchyNode, b:HierarchyNode, isFirst:Boolean):void
        {
            var aboveA:HierarchyNode = _decidingA;
            var aboveB:HierarchyNode = _decidingB;
            var above:Number = bound;
            var highA:HierarchyNode = isFirst ? a.high : a;
            var highB:HierarchyNode = isFirst ? b : b.high;
            a = isFirst ? a.low : a;
            b = isFirst ? b : b.low;
            estimate(a, b);
            var low:Number = bound;
            var lowA:HierarchyNode = _decidingA;
            var lowB:HierarchyNode = _decidingB;
            bound = above;
            _decidingA = aboveA;
            _decidingB = aboveB;
            estimate(highA, highB);
            if (low < bound)
            {
                push(highA, highB, bound, _decidingA, _decidingB);
                push(a, b, low, lowA, lowB);
            }
            else
            {
                push(a, b, low, lowA, lowB);
                push(highA, highB, bound, _decidingA, _decidingB);
            }
        }

        private function push(a:HierarchyNode, b:HierarchyNode, itsBound:Number, itsA:HierarchyNode, itsB:HierarchyNode):void
        {
            if (itsBound >= least)
            {
                return;
            }
            var top:int = 4 * _count;
            _nodes[top] = a;
            _nodes[top + 1] = b;
            _nodes[top + 2] = itsA;
            _nodes[top + 3] = itsB;
            _bounds[_count] = itsBound;
            _count++;
        }
    }
}
