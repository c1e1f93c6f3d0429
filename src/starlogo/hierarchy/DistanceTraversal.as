package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.PairTable;
    import starlogo.intersection.boxes.BoxAxes;
    import starlogo.intersection.boxes.BoxPair;

    /**
     * Finds the distance of two trees. The distance of two boxes' extents, along the axes of one box or the other, is a lower bound of the
     * boxes' distance and takes few products. Only pairs that decide are measured exactly.
     *
     * <p>The results are nested, to the last bit: a result is never greater than the result for greater depths, or for the nodes'
     * triangles. Nodes are a little larger than the nodes below them (Tolerances.NESTING). That outweighs the rounding of short distances.
     * To outweigh the rounding of long distances, a measured distance is reduced a little. The deeper the nodes are, the less it is
     * reduced.</p>
     *
     * @private
     */
    public final class DistanceTraversal extends BestPairTraversal
    {
        // An estimate is smaller than the distances below it by this fraction, which is more than the errors of rounding and nesting.
        private static const SLACK:Number = 1e-12;

        // The second tree's axes times its scale, and the vector from the middle of the first tree's node to the middle of the second's, of the pair
        // that is estimated.
        private var _pair:BoxPair = new BoxPair();

        // The radii of the spheres around both trees together. The rounding error is relative to it.
        private var _radii:Number;

        private var _measured:ClosestPoints = new ClosestPoints();

        /** @param counts counts the pairs of nodes that are visited */
        public function DistanceTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds the closest points of two trees.
         *
         * @param visitor decides about nodes that decide; null if their boxes do
         * @param out receives the points and their distance, in the first model's space
         */
        public function findClosest(trees:PosedTrees, visitor:NodePairVisitor, out:ClosestPoints):void
        {
            var relative:Placement = trees.pose.placement;
            _radii = trees.a.radius + trees.b.radius * relative.size;
            _pair.axes.readAxes(relative, relative.size);
            out.copyFrom(find(trees, visitor).points);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the greatest of three: the distance along a's axes, along b's axes, and along the line between the closest points so far. A
         * pair that is too far away along a's axes need not be estimated exactly.</p>
         */
        override protected function estimate(trees:PosedTrees, a:int, b:int, out:BestPair):void
        {
            var pair:BoxPair = _pair;
            var axes:BoxAxes = pair.axes;
            var pose:RelativePose = trees.pose;
            var relative:Placement = pose.placement;
            var boxes:Vector.<Number> = trees.b.boxes;
            var at:int = 6 * b;
            var bX:Number = boxes[at];
            var bY:Number = boxes[int(at + 1)];
            var bZ:Number = boxes[int(at + 2)];
            var x:Number = axes.m00 * bX + axes.m01 * bY + axes.m02 * bZ + relative.x;
            var y:Number = axes.m10 * bX + axes.m11 * bY + axes.m12 * bZ + relative.y;
            var z:Number = axes.m20 * bX + axes.m21 * bY + axes.m22 * bZ + relative.z;
            bX = boxes[int(at + 3)];
            bY = boxes[int(at + 4)];
            bZ = boxes[int(at + 5)];
            boxes = trees.a.boxes;
            at = 6 * a;
            x -= boxes[at];
            y -= boxes[int(at + 1)];
            z -= boxes[int(at + 2)];
            var distance:Number = x < 0 ? -x : x;
            distance -= boxes[int(at + 3)] + axes.abs00 * bX + axes.abs01 * bY + axes.abs02 * bZ;
            distance = distance > 0 ? distance : 0;
            var squared:Number = distance * distance;
            distance = y < 0 ? -y : y;
            distance -= boxes[int(at + 4)] + axes.abs10 * bX + axes.abs11 * bY + axes.abs12 * bZ;
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            distance = z < 0 ? -z : z;
            distance -= boxes[int(at + 5)] + axes.abs20 * bX + axes.abs21 * bY + axes.abs22 * bZ;
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            var far:Number = out.least + pose.tolerance + 2 * SLACK * (out.least + _radii);
            if (squared > far * far)
            {
                out.bound = out.least;
                return;
            }
            pair.x = x;
            pair.y = y;
            pair.z = z;
            raise(Math.sqrt(squared), pose, out);
            estimateAlongSecond(pair, trees, at, 6 * b, out);
            if (out.points.distance < Infinity)
            {
                estimateAlongLine(pair, trees, at, 6 * b, out);
            }
        }

        // Raises the bound to the distance of two boxes, whose numbers begin at two indices, along the axes of the second one. The products contain its scale.
        private function estimateAlongSecond(pair:BoxPair, trees:PosedTrees, a:int, b:int, out:BestPair):void
        {
            var axes:BoxAxes = pair.axes;
            var boxesA:Vector.<Number> = trees.a.boxes;
            var boxesB:Vector.<Number> = trees.b.boxes;
            var scale:Number = trees.pose.placement.size;
            var x:Number = pair.x;
            var y:Number = pair.y;
            var z:Number = pair.z;
            var halfX:Number = boxesA[int(a + 3)];
            var halfY:Number = boxesA[int(a + 4)];
            var halfZ:Number = boxesA[int(a + 5)];
            var distance:Number = axes.m00 * x + axes.m10 * y + axes.m20 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs00 * halfX - axes.abs10 * halfY - axes.abs20 * halfZ) / scale - scale * boxesB[int(b + 3)];
            distance = distance > 0 ? distance : 0;
            var squared:Number = distance * distance;
            distance = axes.m01 * x + axes.m11 * y + axes.m21 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs01 * halfX - axes.abs11 * halfY - axes.abs21 * halfZ) / scale - scale * boxesB[int(b + 4)];
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            distance = axes.m02 * x + axes.m12 * y + axes.m22 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs02 * halfX - axes.abs12 * halfY - axes.abs22 * halfZ) / scale - scale * boxesB[int(b + 5)];
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            raise(Math.sqrt(squared), trees.pose, out);
        }

        // Raises the bound to the distance of two boxes along the line between the closest points so far. It rules out most of the pairs that are not
        // nearer.
        private function estimateAlongLine(pair:BoxPair, trees:PosedTrees, a:int, b:int, out:BestPair):void
        {
            var axes:BoxAxes = pair.axes;
            var boxesA:Vector.<Number> = trees.a.boxes;
            var boxesB:Vector.<Number> = trees.b.boxes;
            var points:ClosestPoints = out.points;
            var toX:Number = points.b.x - points.a.x;
            var toY:Number = points.b.y - points.a.y;
            var toZ:Number = points.b.z - points.a.z;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            if (!(length > 0))
            {
                return;
            }
            var alongX:Number = toX * axes.m00 + toY * axes.m10 + toZ * axes.m20;
            var alongY:Number = toX * axes.m01 + toY * axes.m11 + toZ * axes.m21;
            var alongZ:Number = toX * axes.m02 + toY * axes.m12 + toZ * axes.m22;
            alongX = alongX < 0 ? -alongX : alongX;
            alongY = alongY < 0 ? -alongY : alongY;
            alongZ = alongZ < 0 ? -alongZ : alongZ;
            var distance:Number = pair.x * toX + pair.y * toY + pair.z * toZ
                - alongX * boxesB[int(b + 3)] - alongY * boxesB[int(b + 4)] - alongZ * boxesB[int(b + 5)];
            toX = toX < 0 ? -toX : toX;
            toY = toY < 0 ? -toY : toY;
            toZ = toZ < 0 ? -toZ : toZ;
            raise((distance - boxesA[int(a + 3)] * toX - boxesA[int(a + 4)] * toY - boxesA[int(a + 5)] * toZ) / length, trees.pose, out);
        }

        // Raises the bound to a computed distance, less its rounding error.
        private function raise(distance:Number, pose:RelativePose, out:BestPair):void
        {
            var bound:Number = distance - SLACK * (distance + _radii) - pose.tolerance;
            if (bound > out.bound)
            {
                out.bound = bound;
            }
        }

        /** @inheritDoc */
        override protected function measure(trees:PosedTrees, a:int, b:int, visitor:NodePairVisitor, out:BestPair):void
        {
            if (visitor != null)
            {
                visitor.findCloser(a, b, out);
                return;
            }
            var placedB:BoundingStructure = trees.pose.placeWidened(trees.b.boxOf(b));
            PairTable.findClosest(trees.a.boxOf(a), placedB, _measured);
            reduce(_measured, trees.a.levelOf(a), trees.b.levelOf(b), _radii);
            if (_measured.distance < out.least)
            {
                out.least = _measured.distance;
                out.points.copyFrom(_measured);
            }
        }

        /**
         * Reduces a measured distance of two nodes by more than its rounding error and the margins of nested nodes.
         *
         * @param levelA the level of a node; 0 for a structure
         * @param levelB the level of the other
         * @param radii the radii of both models together
         */
        internal static function reduce(measured:ClosestPoints, levelA:int, levelB:int, radii:Number):void
        {
            var distance:Number = measured.distance - Tolerances.NESTING * (levelsBelow(levelA) + levelsBelow(levelB)) * (measured.distance + radii);
            measured.distance = distance > 0 ? distance : 0;
        }

        // The number of levels that a tree may have below a node on a level, plus one. A single structure counts as the last level.
        private static function levelsBelow(level:int):int
        {
            return level == 0 || level > Tolerances.NESTED_LEVELS ? 1 : 1 + Tolerances.NESTED_LEVELS - level;
        }
    }
}
