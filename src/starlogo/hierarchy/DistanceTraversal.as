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
     * Finds the distance of two trees: branch and bound, depth-first, the nearer of two pairs first (Larsen, Gottschalk, Lin and Manocha,
     * "Fast proximity queries with swept sphere volumes", 1999). The result is the distance of the nearest two nodes that are leaves or at
     * their depth limit. A pair is skipped if nothing below it can be nearer than the result so far.
     *
     * <p>The results are nested, to the last bit: a result is never greater than the result for greater depths, or for the leaves'
     * contents. Nodes are a little larger than the nodes below them (Tolerances.NESTING). That outweighs the rounding of short distances.
     * To outweigh the rounding of long distances, a measured distance is reduced a little. The deeper the nodes are, the less it is
     * reduced.</p>
     *
     * <p>This class takes all structures. A pair's distance is at least its ancestors' distance, as in a StructureTraversal. BoxDistances
     * has a faster way for boxes.</p>
     *
     * @private
     */
    public class DistanceTraversal
    {
        /** The result: the smallest distance, in the first model's space. */
        public var least:Number;

        /** The number of pairs of nodes visited. The caller sets it to 0. */
        public var nodeVisits:int = 0;

        /** The second model's pose in the first model's space. */
        protected var pose:RelativePose;

        /** How far both models together extend from their middles. The rounding error is relative to it. */
        protected var reach:Number;

        /** A lower bound of the distances of the current pair and of all below it. Before estimate, the bound of the pair above. */
        protected var bound:Number;

        /** The vector from the first model's point to the second's at the smallest distance so far. */
        protected var directionX:Number;

        /** @copy #directionX */
        protected var directionY:Number;

        /** @copy #directionX */
        protected var directionZ:Number;

        /** The distance of the pair measured last, or a little less. */
        protected var measured:Number;

        // The two nodes that determine the current pair's bound: the pair itself or one above it. The two nodes that determine the smallest
        // distance.
        private var _decidingA:HierarchyNode;
        private var _decidingB:HierarchyNode;
        private var _nearestA:HierarchyNode;
        private var _nearestB:HierarchyNode;

        private var _pair:NodePair;
        private var _points:ClosestPair = new ClosestPair();

        // The pairs still to visit, each with the nodes that determine its bound.
        private var _count:int;
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _bounds:Vector.<Number> = new Vector.<Number>();

        /**
         * @param pose the second model's pose in the first model's space; kept, and read for each pair of models
         */
        public function DistanceTraversal(pose:RelativePose)
        {
            this.pose = pose;
            _pair = new NodePair(pose);
        }

        /**
         * Finds the smallest distance of two nodes that are leaves or at their depth limit, and sets <code>least</code> to it.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many of its levels are visited
         * @param b the root of the second model's hierarchy
         * @param depthB how many of its levels are visited
         * @param leaves finds the distance of such nodes; null to take the distance of their structures
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
                    least = leaves.points.distance;
                    turnTo(leaves.points);
                }
                else
                {
                    settle(a, b);
                    if (bound < least)
                    {
                        least = bound;
                        _nearestA = _decidingA;
                        _nearestB = _decidingB;
                        turnTo(_points);
                    }
                }
            }
        }

        /** How far a structure extends from its middle, or a little more. The rounding error of distances is relative to it. */
        public static function reachOf(structure:BoundingStructure):Number
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    var sphere:Sphere = Sphere(structure);
                    return sphere.radius;
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

        /**
         * Writes the smallest distance and the closest points of the nodes that determine it, in the first model's space. Not for a
         * <code>find</code> with leaves.
         */
        public final function writePoints(out:ClosestPair):void
        {
            _pair.begin();
            _pair.place(_nearestA, _nearestB);
            findClosest(_pair.a, _pair.b, out);
            out.distance = least;
        }

        /** Prepares the traversal of two models in their pose. */
        protected function begin():void
        {
        }

        /** Raises the bound to a lower bound of the pair's distance, if that is greater. */
        protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
            measure(a, b);
            raise(a, b);
        }

        /** Whether the first of two nodes is divided. The order is level by level, so that results are nested for all depths. */
        protected function dividesFirst(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return a.level <= b.level;
        }

        /** Sets the bound of a pair that is not divided to the pair's distance. */
        protected function settle(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /** Measures the distance of the structures of two nodes. */
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

        /** Raises the bound to the measured distance, if that is greater. */
        protected final function raise(a:HierarchyNode, b:HierarchyNode):void
        {
            if (measured >= bound)
            {
                bound = measured;
                _decidingA = a;
                _decidingB = b;
            }
        }

        // The number of levels that a tree may have below a node, plus one. A single structure counts as the last level.
        private static function levelsBelow(node:HierarchyNode):int
        {
            var level:int = node.level;
            return level == 0 || level > Tolerances.NESTED_LEVELS ? 1 : 1 + Tolerances.NESTED_LEVELS - level;
        }

        private function turnTo(points:ClosestPair):void
        {
            directionX = points.bX - points.aX;
            directionY = points.bY - points.aY;
            directionZ = points.bZ - points.aZ;
        }

        // Puts a node's children, each paired with the other node, on the stack. The nearer pair is on top.
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
