package starlogo.intersection.boxes
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

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

        // The rotation of b, row by row: its columns are the directions of b's edges. And the half-extents of b.
        private var _rows:Vector.<Number> = new Vector.<Number>(9, true);
        private var _halves:Vector.<Number> = new Vector.<Number>(3, true);

        private var _times:ContactInterval = new ContactInterval();

        // Two boxes that are given as structures, and the motion of the second as seen from the first.
        private var _boxes:BoxPair = new BoxPair();
        private var _motion:RelativeMotion = new RelativeMotion();

        /**
         * Whether two boxes touch where they stand. It takes longer than <code>boxBox()</code>, but its axes across edges do not cancel if the edges
         * are nearly parallel.
         */
        public static function areTouching(a:Box, b:Box):Boolean
        {
            SCRATCH.findTimeOfImpactOfBoxes(a, b, STANDING);
            return STANDING.time == 0;
        }

        /**
         * Finds when a moving box first touches another one.
         *
         * @param motion the motion of a; receives the time
         */
        public function findTimeOfImpactOfBoxes(a:Box, b:Box, motion:RelativeMotion):void
        {
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            // while a moves, b moves in the opposite direction as seen from a
            var axis:Vector3D = a.axisX;
            _motion.x = -(axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _boxes.offsetX = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisY;
            _motion.y = -(axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _boxes.offsetY = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisZ;
            _motion.z = -(axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _boxes.offsetZ = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            _boxes.setBoxes(a, b);
            _boxes.margin = motion.margin;
            _motion.latestTime = motion.latestTime;
            findTimeOfImpact(_boxes, _motion);
            motion.time = _motion.time;
        }

        /**
         * Finds when the boxes of a pair first touch.
         *
         * @param motion of b, in the axes of a; receives the time. Its start does not count
         */
        public function findTimeOfImpact(pair:BoxPair, motion:RelativeMotion):void
        {
            _times.reset(motion.latestTime);
            writeTime(clipByFaces(pair, motion) && clipByEdges(pair, motion), motion);
        }

        /**
         * Finds from which time on no face separates the boxes of a pair. The boxes do not touch earlier.
         *
         * @param motion as in findTimeOfImpact(); receives the time
         */
        public function findEarliestTime(pair:BoxPair, motion:RelativeMotion):void
        {
            _times.reset(motion.latestTime);
            writeTime(clipByFaces(pair, motion), motion);
        }

        // Writes from which time on no axis that was tried separates the boxes, if anything is left of the interval.
        private function writeTime(isAnyLeft:Boolean, motion:RelativeMotion):void
        {
            motion.time = isAnyLeft ? Math.min(_times.timeOfImpact, _times.latestTime) : RelativeMotion.NEVER;
        }

        // Clips the interval by the faces of both. Returns whether anything is left.
        private function clipByFaces(pair:BoxPair, motion:RelativeMotion):Boolean
        {
            var rotation:Placement = pair.rotation;
            var fromX:Number = pair.offsetX;
            var fromY:Number = pair.offsetY;
            var fromZ:Number = pair.offsetZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            return clipByAxis(pair, fromX, motion.x, aHalfX + bHalfX * pair.abs00 + bHalfY * pair.abs01 + bHalfZ * pair.abs02, 1)
                && clipByAxis(pair, fromY, motion.y, aHalfY + bHalfX * pair.abs10 + bHalfY * pair.abs11 + bHalfZ * pair.abs12, 1)
                && clipByAxis(pair, fromZ, motion.z, aHalfZ + bHalfX * pair.abs20 + bHalfY * pair.abs21 + bHalfZ * pair.abs22, 1)
                && clipByAxis(pair, fromX * rotation.r00 + fromY * rotation.r10 + fromZ * rotation.r20,
                    rotation.r00 * motion.x + rotation.r10 * motion.y + rotation.r20 * motion.z,
                    bHalfX + aHalfX * pair.abs00 + aHalfY * pair.abs10 + aHalfZ * pair.abs20, 1)
                && clipByAxis(pair, fromX * rotation.r01 + fromY * rotation.r11 + fromZ * rotation.r21,
                    rotation.r01 * motion.x + rotation.r11 * motion.y + rotation.r21 * motion.z,
                    bHalfY + aHalfX * pair.abs01 + aHalfY * pair.abs11 + aHalfZ * pair.abs21, 1)
                && clipByAxis(pair, fromX * rotation.r02 + fromY * rotation.r12 + fromZ * rotation.r22,
                    rotation.r02 * motion.x + rotation.r12 * motion.y + rotation.r22 * motion.z,
                    bHalfZ + aHalfX * pair.abs02 + aHalfY * pair.abs12 + aHalfZ * pair.abs22, 1);
        }

        // Clips the interval by an axis, if it is longer than rounding. Returns whether anything is left. @param size at least the length of the axis
        private function clipByAxis(pair:BoxPair, offset:Number, speed:Number, halfExtents:Number, size:Number):Boolean
        {
            return !(size > SHORTEST) || _times.clip(offset, speed, halfExtents, pair.margin * size);
        }

        // Clips the interval by the edges of both. Returns whether anything is left. The boxes are projected in full on the cross product of an edge of
        // each. So even a short cross product of nearly parallel edges is an axis like any other. The test uses no identity between axes, because
        // rounding would break it.
        private function clipByEdges(pair:BoxPair, motion:RelativeMotion):Boolean
        {
            pair.rotation.readRows(_rows, 0);
            _halves[0] = pair.bHalfX;
            _halves[1] = pair.bHalfY;
            _halves[2] = pair.bHalfZ;
            return clipAcross(pair, motion, 0, 1, 2) && clipAcross(pair, motion, 1, 2, 0) && clipAcross(pair, motion, 2, 0, 1);
        }

        // Clips the interval by the cross products of edge p of b and the three edges of a, which are the coordinate axes. q and r are b's other edges.
        // All three are columns of the rotation. Returns whether anything is left.
        private function clipAcross(pair:BoxPair, motion:RelativeMotion, p:int, q:int, r:int):Boolean
        {
            var rows:Vector.<Number> = _rows;
            var halfQ:Number = _halves[q];
            var halfR:Number = _halves[r];
            var pX:Number = rows[p];
            var pY:Number = rows[int(p + 3)];
            var pZ:Number = rows[int(p + 6)];
            var qX:Number = halfQ * rows[q];
            var qY:Number = halfQ * rows[int(q + 3)];
            var qZ:Number = halfQ * rows[int(q + 6)];
            var rX:Number = halfR * rows[r];
            var rY:Number = halfR * rows[int(r + 3)];
            var rZ:Number = halfR * rows[int(r + 6)];
            var sizeX:Number = Math.abs(pX);
            var sizeY:Number = Math.abs(pY);
            var sizeZ:Number = Math.abs(pZ);
            return clipByAxis(pair, pair.offsetZ * pY - pair.offsetY * pZ, motion.z * pY - motion.y * pZ,
                    pair.aHalfY * sizeZ + pair.aHalfZ * sizeY + Math.abs(qZ * pY - qY * pZ) + Math.abs(rZ * pY - rY * pZ), sizeY + sizeZ)
                && clipByAxis(pair, pair.offsetX * pZ - pair.offsetZ * pX, motion.x * pZ - motion.z * pX,
                    pair.aHalfZ * sizeX + pair.aHalfX * sizeZ + Math.abs(qX * pZ - qZ * pX) + Math.abs(rX * pZ - rZ * pX), sizeX + sizeZ)
                && clipByAxis(pair, pair.offsetY * pX - pair.offsetX * pY, motion.y * pX - motion.x * pY,
                    pair.aHalfX * sizeY + pair.aHalfY * sizeX + Math.abs(qY * pX - qX * pY) + Math.abs(rY * pX - rX * pY), sizeX + sizeY);
        }
    }
}
