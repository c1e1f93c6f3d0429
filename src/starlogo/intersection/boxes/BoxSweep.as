package starlogo.intersection.boxes
{
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Finds when two moving boxes first touch, by separating axes over time (Eberly, "Intersection of convex objects: the method of separating axes",
     * 2001). Boxes touch while no axis separates them. Each axis gives an interval of time during which it does not separate them. The boxes first touch
     * when the last interval begins, if that is before the first one ends.
     *
     * @private
     */
    public final class BoxSweep
    {
        // Below this length a cross product is only rounding, because the edges are parallel (Tolerances.PARALLEL).
        private static const SHORTEST:Number = Math.sqrt(Tolerances.PARALLEL);

        // For areTouching().
        private static const SCRATCH:BoxSweep = new BoxSweep();
        private static const STANDING:RelativeMotion = new RelativeMotion();

        private var _times:ContactInterval = new ContactInterval();

        /**
         * Whether two boxes touch where they stand. It takes longer than <code>boxBox()</code>, but its axes across edges do not cancel if the edges
         * are nearly parallel.
         */
        public static function areTouching(a:Box, b:Box):Boolean
        {
            BoxPair.SCRATCH.setMoving(a, b, STANDING);
            SCRATCH.findTimeOfImpact(BoxPair.SCRATCH, STANDING);
            return STANDING.time == 0;
        }

        /**
         * Finds when the boxes of a pair first touch.
         *
         * @param motion has the latest time, and receives the time. The pair has its vector
         */
        public function findTimeOfImpact(pair:BoxPair, motion:RelativeMotion):void
        {
            _times.reset(motion.latestTime);
            writeTime(clipByFaces(pair) && clipByEdges(pair), motion);
        }

        /**
         * Finds from which time on no face separates the boxes of a pair. The boxes do not touch earlier.
         *
         * @param motion as in findTimeOfImpact(); receives the time
         */
        public function findEarliestTime(pair:BoxPair, motion:RelativeMotion):void
        {
            _times.reset(motion.latestTime);
            writeTime(clipByFaces(pair), motion);
        }

        // Writes from which time on no axis that was tried separates the boxes, if anything is left of the interval.
        private function writeTime(isAnyLeft:Boolean, motion:RelativeMotion):void
        {
            motion.time = isAnyLeft ? Math.min(_times.timeOfImpact, _times.latestTime) : RelativeMotion.NEVER;
        }

        // Clips the interval by the faces of both. Returns whether anything is left.
        private function clipByFaces(pair:BoxPair):Boolean
        {
            var rotation:Vector.<Number> = pair.rotation;
            var absolutes:Vector.<Number> = pair.absolutes;
            var offset:Vector.<Number> = pair.offset;
            var motion:Vector.<Number> = pair.motion;
            var halvesA:Vector.<Number> = pair.halvesA;
            var halvesB:Vector.<Number> = pair.halvesB;
            for (var i:int = 0; i < 3; i++)
            {
                var halfExtents:Number = halvesA[i] + halvesB[0] * absolutes[int(3 * i)] + halvesB[1] * absolutes[int(3 * i + 1)] + halvesB[2] * absolutes[int(3 * i + 2)];
                if (!_times.clip(offset[i], motion[i], halfExtents, pair.margin))
                {
                    return false;
                }
            }
            for (i = 0; i < 3; i++)
            {
                var from:Number = offset[0] * rotation[i] + offset[1] * rotation[int(i + 3)] + offset[2] * rotation[int(i + 6)];
                var speed:Number = rotation[i] * motion[0] + rotation[int(i + 3)] * motion[1] + rotation[int(i + 6)] * motion[2];
                halfExtents = halvesB[i] + halvesA[0] * absolutes[i] + halvesA[1] * absolutes[int(i + 3)] + halvesA[2] * absolutes[int(i + 6)];
                if (!_times.clip(from, speed, halfExtents, pair.margin))
                {
                    return false;
                }
            }
            return true;
        }

        // Clips the interval by the cross products of an edge of b and an edge of a. Edge p of b is a column of the rotation, and edge i of a is a coordinate
        // axis. The boxes are projected in full on the cross product. So even a short one of nearly parallel edges is an axis like any other. The test uses
        // no identity between axes, because rounding would break it. Returns whether anything is left.
        private function clipByEdges(pair:BoxPair):Boolean
        {
            var rotation:Vector.<Number> = pair.rotation;
            var offset:Vector.<Number> = pair.offset;
            var motion:Vector.<Number> = pair.motion;
            var halvesA:Vector.<Number> = pair.halvesA;
            for (var p:int = 0; p < 3; p++)
            {
                // the other two edges of b
                var q:int = p == 2 ? 0 : p + 1;
                var r:int = 3 - p - q;
                var halfQ:Number = pair.halvesB[q];
                var halfR:Number = pair.halvesB[r];
                for (var i:int = 0; i < 3; i++)
                {
                    // the other two edges of a, and their rows
                    var j:int = i == 2 ? 0 : i + 1;
                    var k:int = 3 - i - j;
                    var rowJ:int = 3 * j;
                    var rowK:int = 3 * k;
                    var edgeJ:Number = rotation[int(rowJ + p)];
                    var edgeK:Number = rotation[int(rowK + p)];
                    var sizeJ:Number = Math.abs(edgeJ);
                    var sizeK:Number = Math.abs(edgeK);
                    var halfExtents:Number = halvesA[j] * sizeK + halvesA[k] * sizeJ
                        + Math.abs(halfQ * rotation[int(rowK + q)] * edgeJ - halfQ * rotation[int(rowJ + q)] * edgeK)
                        + Math.abs(halfR * rotation[int(rowK + r)] * edgeJ - halfR * rotation[int(rowJ + r)] * edgeK);
                    if (sizeJ + sizeK > SHORTEST && !_times.clip(offset[k] * edgeJ - offset[j] * edgeK, motion[k] * edgeJ - motion[j] * edgeK, halfExtents, pair.margin * (sizeJ + sizeK)))
                    {
                        return false;
                    }
                }
            }
            return true;
        }
    }
}
