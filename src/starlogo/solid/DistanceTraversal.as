package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.StructurePairs;
    import starlogo.intersection.boxes.BoxPair;

    /**
     * Finds the distance of two trees. The distance of two boxes' extents, along the axes of one box or the other, is a lower bound of the
     * boxes' distance and takes few products. Only pairs of leaves are measured exactly.
     *
     * <p>The results are nested, to the last bit: a result is never greater than the result for greater depths, or for the nodes'
     * triangles. Nodes are a little larger than the nodes below them (Tolerances.NESTING). That outweighs the rounding of short distances.
     * To outweigh the rounding of long distances, a measured distance is reduced a little. The deeper the nodes are, the less it is
     * reduced.</p>
     */
    internal final class DistanceTraversal extends BestPairTraversal
    {
        // An estimate is smaller than the distances below it by this fraction, which is more than the errors of rounding and nesting.
        private static const SLACK:Number = 1e-12;

        // The rotation of tree b, and the pair that is estimated.
        private var _pair:BoxPair = new BoxPair();

        // The radii of the spheres about both origins that contain the trees, together. The rounding error is relative to it.
        private var _radii:Number;

        // The closest points of the best pair so far, and of the leaves that are measured.
        private var _nearest:ClosestPoints;
        private var _measured:ClosestPoints = new ClosestPoints();

        /** @param counts counts the pairs of nodes that are visited */
        public function DistanceTraversal(counts:TreeCounts)
        {
            super(counts);
        }

        /**
         * Finds the closest points of two trees.
         *
         * @param kernel measures the triangles of two leaves, if the trees are exact. It has begun with them
         * @param out receives the points and their distance, in a's space
         */
        public function findClosest(trees:TreePair, kernel:TrianglePairKernel, out:ClosestPoints):void
        {
            _radii = trees.a.radiusAboutOrigin + trees.b.radiusAboutOrigin * trees.pose.placement.size;
            _pair.setRotation(trees.pose.placement);
            _nearest = out;
            out.distance = Infinity;
            visitPairs(trees, kernel);
        }

        /**
         * @inheritDoc
         *
         * <p>The bound is the greatest of three: the distance along a's axes, along b's axes, and along the line between the closest points so far. A
         * pair that is too far away along a's axes need not be estimated exactly.</p>
         */
        override protected function estimate(trees:TreePair, a:int, b:int):void
        {
            var pair:BoxPair = _pair;
            trees.readBoxes(a, b, pair);
            var absolutes:Vector.<Number> = pair.absolutes;
            var offset:Vector.<Number> = pair.offset;
            var halvesA:Vector.<Number> = pair.halvesA;
            var halvesB:Vector.<Number> = pair.halvesB;
            // measure() widens b's boxes as well
            halvesB[0] += trees.pose.margin;
            halvesB[1] += trees.pose.margin;
            halvesB[2] += trees.pose.margin;
            var distance:Number = Math.abs(offset[0]) - (halvesA[0] + absolutes[0] * halvesB[0] + absolutes[1] * halvesB[1] + absolutes[2] * halvesB[2]);
            distance = distance > 0 ? distance : 0;
            var squared:Number = distance * distance;
            distance = Math.abs(offset[1]) - (halvesA[1] + absolutes[3] * halvesB[0] + absolutes[4] * halvesB[1] + absolutes[5] * halvesB[2]);
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            distance = Math.abs(offset[2]) - (halvesA[2] + absolutes[6] * halvesB[0] + absolutes[7] * halvesB[1] + absolutes[8] * halvesB[2]);
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            var far:Number = limit + 2 * SLACK * (limit + _radii);
            if (squared > far * far)
            {
                bound = limit;
                return;
            }
            raiseBound(Math.sqrt(squared));
            estimateAlongAxesOfB(pair);
            if (_nearest.distance < Infinity)
            {
                estimateAlongLine(pair);
            }
        }

        // Raises the bound to the distance of two boxes along the axes of b's.
        private function estimateAlongAxesOfB(pair:BoxPair):void
        {
            var rotation:Vector.<Number> = pair.rotation;
            var absolutes:Vector.<Number> = pair.absolutes;
            var offset:Vector.<Number> = pair.offset;
            var halvesA:Vector.<Number> = pair.halvesA;
            var halvesB:Vector.<Number> = pair.halvesB;
            var distance:Number = Math.abs(rotation[0] * offset[0] + rotation[3] * offset[1] + rotation[6] * offset[2])
                - (absolutes[0] * halvesA[0] + absolutes[3] * halvesA[1] + absolutes[6] * halvesA[2] + halvesB[0]);
            distance = distance > 0 ? distance : 0;
            var squared:Number = distance * distance;
            distance = Math.abs(rotation[1] * offset[0] + rotation[4] * offset[1] + rotation[7] * offset[2])
                - (absolutes[1] * halvesA[0] + absolutes[4] * halvesA[1] + absolutes[7] * halvesA[2] + halvesB[1]);
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            distance = Math.abs(rotation[2] * offset[0] + rotation[5] * offset[1] + rotation[8] * offset[2])
                - (absolutes[2] * halvesA[0] + absolutes[5] * halvesA[1] + absolutes[8] * halvesA[2] + halvesB[2]);
            distance = distance > 0 ? distance : 0;
            squared += distance * distance;
            raiseBound(Math.sqrt(squared));
        }

        // Raises the bound to the distance of two boxes along the line between the closest points so far. It rules out most of the pairs that are not
        // nearer.
        private function estimateAlongLine(pair:BoxPair):void
        {
            var rotation:Vector.<Number> = pair.rotation;
            var points:ClosestPoints = _nearest;
            var toX:Number = points.b.x - points.a.x;
            var toY:Number = points.b.y - points.a.y;
            var toZ:Number = points.b.z - points.a.z;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            if (!(length > 0))
            {
                return;
            }
            var distance:Number = pair.offset[0] * toX + pair.offset[1] * toY + pair.offset[2] * toZ;
            distance -= Math.abs(toX * rotation[0] + toY * rotation[3] + toZ * rotation[6]) * pair.halvesB[0];
            distance -= Math.abs(toX * rotation[1] + toY * rotation[4] + toZ * rotation[7]) * pair.halvesB[1];
            distance -= Math.abs(toX * rotation[2] + toY * rotation[5] + toZ * rotation[8]) * pair.halvesB[2];
            raiseBound((distance - pair.halvesA[0] * Math.abs(toX) - pair.halvesA[1] * Math.abs(toY) - pair.halvesA[2] * Math.abs(toZ)) / length);
        }

        // Raises the bound to a computed distance, less its rounding error.
        private function raiseBound(distance:Number):void
        {
            var raised:Number = distance - SLACK * (distance + _radii);
            if (raised > bound)
            {
                bound = raised;
            }
        }

        /** @inheritDoc */
        override protected function measure(trees:TreePair, a:int, b:int, kernel:TrianglePairKernel):void
        {
            if (trees.isExact)
            {
                kernel.findCloser(a, b, _nearest);
                limit = _nearest.distance;
                return;
            }
            var placedB:BoundingStructure = trees.pose.placeWidened(trees.b.boxOf(b));
            StructurePairs.findClosest(trees.a.boxOf(a), placedB, _measured);
            subtractNesting(_measured, trees.a.levelOf(a), trees.b.levelOf(b), _radii);
            if (_measured.distance < limit)
            {
                limit = _measured.distance;
                _nearest.copyFrom(_measured);
            }
        }

        /**
         * Reduces a measured distance of two nodes by more than its rounding error and the margins of nested nodes.
         *
         * @param levelA the level of a's node
         * @param levelB the level of b's node; 0 for a structure
         * @param radii the rounding error is relative to this length and the distance together
         */
        internal static function subtractNesting(measured:ClosestPoints, levelA:int, levelB:int, radii:Number):void
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
