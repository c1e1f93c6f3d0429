package starlogo.hierarchy
{
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.PairTable;
    import starlogo.intersection.sweep.BoxAxes;

    use namespace engine;

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

        // The second model's axes, times its scale.
        private var _axes:BoxAxes = new BoxAxes();

        // The radii of the spheres around both trees together. The rounding error is relative to it.
        private var _radii:Number;

        private var _measured:ClosestPoints = new ClosestPoints();
        private var _boxA:Box = BoxTree.newBox();
        private var _boxB:Box = BoxTree.newBox();

        /** @param counts counts the pairs of nodes that are visited */
        public function DistanceTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds the closest points of two trees. The other parameters are those of <code>BestPairTraversal.find()</code>.
         *
         * @param out receives the points and their distance, in the first model's space
         */
        public function findClosest(pose:RelativePose, treeA:BoxTree, depthA:int, treeB:BoxTree, depthB:int, visitor:BestPairVisitor, out:ClosestPoints):void
        {
            _radii = treeA.radius + treeB.radius * pose.placement.size;
            _axes.readAxes(pose.placement, pose.placement.size);
            out.copyFrom(find(pose, treeA, depthA, treeB, depthB, visitor).points);
        }

        /**
         * @inheritDoc
         *
         * <p>The steps are: the vector from the middle of a's box to the middle of b's box; the distances along a's axes; the distances along b's axes;
         * the distance along the line between the closest points so far. They are one method because they share twelve Numbers, which V8 would make
         * objects of if they were passed.</p>
         */
        override protected function estimate(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, out:BestPair):void
        {
            var axes:BoxAxes = _axes;
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var boxes:Vector.<Number> = treeB.boxes;
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
            boxes = treeA.boxes;
            at = 6 * a;
            x -= boxes[at];
            y -= boxes[int(at + 1)];
            z -= boxes[int(at + 2)];
            var halfX:Number = boxes[int(at + 3)];
            var halfY:Number = boxes[int(at + 4)];
            var halfZ:Number = boxes[int(at + 5)];
            var squared:Number = 0;
            var distance:Number = x < 0 ? -x : x;
            distance -= halfX + axes.abs00 * bX + axes.abs01 * bY + axes.abs02 * bZ;
            if (distance > 0)
            {
                squared = distance * distance;
            }
            distance = y < 0 ? -y : y;
            distance -= halfY + axes.abs10 * bX + axes.abs11 * bY + axes.abs12 * bZ;
            if (distance > 0)
            {
                squared += distance * distance;
            }
            distance = z < 0 ? -z : z;
            distance -= halfZ + axes.abs20 * bX + axes.abs21 * bY + axes.abs22 * bZ;
            if (distance > 0)
            {
                squared += distance * distance;
            }

            // A pair that is too far away anyway need not be estimated exactly.
            var far:Number = out.least + pose.tolerance + 2 * SLACK * (out.least + _radii);
            if (squared > far * far)
            {
                out.current = out.least;
                return;
            }

            // These products contain the scale.
            var squaredInB:Number = 0;
            distance = axes.m00 * x + axes.m10 * y + axes.m20 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs00 * halfX - axes.abs10 * halfY - axes.abs20 * halfZ) / scale - scale * bX;
            if (distance > 0)
            {
                squaredInB = distance * distance;
            }
            distance = axes.m01 * x + axes.m11 * y + axes.m21 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs01 * halfX - axes.abs11 * halfY - axes.abs21 * halfZ) / scale - scale * bY;
            if (distance > 0)
            {
                squaredInB += distance * distance;
            }
            distance = axes.m02 * x + axes.m12 * y + axes.m22 * z;
            distance = distance < 0 ? -distance : distance;
            distance = (distance - axes.abs02 * halfX - axes.abs12 * halfY - axes.abs22 * halfZ) / scale - scale * bZ;
            if (distance > 0)
            {
                squaredInB += distance * distance;
            }
            var bound:Number = Math.sqrt(squared > squaredInB ? squared : squaredInB);

            // The line between the closest points so far rules out most of the pairs that are not nearer.
            var points:ClosestPoints = out.points;
            var toX:Number = points.bX - points.aX;
            var toY:Number = points.bY - points.aY;
            var toZ:Number = points.bZ - points.aZ;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            if (length > 0 && points.distance < Infinity)
            {
                var alongX:Number = toX * axes.m00 + toY * axes.m10 + toZ * axes.m20;
                var alongY:Number = toX * axes.m01 + toY * axes.m11 + toZ * axes.m21;
                var alongZ:Number = toX * axes.m02 + toY * axes.m12 + toZ * axes.m22;
                alongX = alongX < 0 ? -alongX : alongX;
                alongY = alongY < 0 ? -alongY : alongY;
                alongZ = alongZ < 0 ? -alongZ : alongZ;
                distance = x * toX + y * toY + z * toZ - alongX * bX - alongY * bY - alongZ * bZ;
                toX = toX < 0 ? -toX : toX;
                toY = toY < 0 ? -toY : toY;
                toZ = toZ < 0 ? -toZ : toZ;
                distance = (distance - halfX * toX - halfY * toY - halfZ * toZ) / length;
                if (distance > bound)
                {
                    bound = distance;
                }
            }
            bound -= SLACK * (bound + _radii) + pose.tolerance;
            if (bound > out.current)
            {
                out.current = bound;
            }
        }

        /** @inheritDoc */
        override protected function settle(pose:RelativePose, treeA:BoxTree, a:int, treeB:BoxTree, b:int, visitor:BestPairVisitor, out:BestPair):void
        {
            if (visitor != null)
            {
                visitor.findBest(treeA, a, treeB, b, out);
                return;
            }
            PairTable.findClosest(treeA.writeBox(a, _boxA), pose.placeWidened(treeB.writeBox(b, _boxB)), _measured);
            reduce(_measured, treeA.levelOf(a), treeB.levelOf(b), _radii);
            out.current = _measured.distance;
            if (out.current < out.least)
            {
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
