package starlogo.intersection.boxes
{
    import flash.geom.Vector3D;
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
        private static var sSweep:BoxSweep = new BoxSweep();

        // The directions of b's edges, and half of each edge as a vector: along axisX, axisY, axisZ.
        private var _edges:Vector.<Number> = new Vector.<Number>(9, true);
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        private var _times:ContactInterval = new ContactInterval();

        // The pair of two boxes that are given as structures.
        private var _boxes:BoxPair = new BoxPair();

        /**
         * Whether two boxes touch where they stand. It takes longer than <code>boxBox()</code>, but its axes across edges do not cancel if the edges
         * are nearly parallel.
         */
        public static function areTouching(a:Box, b:Box):Boolean
        {
            var pair:BoxPair = sSweep._boxes;
            setPair(a, b, RelativeMotion.NONE, pair);
            sSweep.findTimeOfImpact(pair);
            return pair.time == 0;
        }

        /**
         * Finds when a moving box first touches another one.
         *
         * @param motion the motion of a; receives the time
         */
        public function findTimeOfBoxes(a:Box, b:Box, motion:RelativeMotion):void
        {
            setPair(a, b, motion, _boxes);
            findTimeOfImpact(_boxes);
            motion.time = _boxes.time;
        }

        /** Sets the pair's time to the first at which the boxes touch. It is NEVER if it is after the latest time. */
        public function findTimeOfImpact(pair:BoxPair):void
        {
            _times.reset(pair.latestTime);
            writeTime(narrowByFaces(pair) && narrowByEdges(pair), pair);
        }

        /**
         * Sets the pair's time to the first from which no face separates the boxes. The boxes touch at that time or later. It is NEVER if it is
         * after the latest time.
         */
        public function findTimeOfFaces(pair:BoxPair):void
        {
            _times.reset(pair.latestTime);
            writeTime(narrowByFaces(pair), pair);
        }

        // Sets the pair of two boxes. While a moves, b moves in the opposite direction as seen from a.
        private static function setPair(a:Box, b:Box, motion:RelativeMotion, pair:BoxPair):void
        {
            var moveX:Number = motion.x;
            var moveY:Number = motion.y;
            var moveZ:Number = motion.z;
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            var axis:Vector3D = a.axisX;
            pair.motionX = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.offsetX = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisY;
            pair.motionY = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.offsetY = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisZ;
            pair.motionZ = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.offsetZ = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            pair.axes.setTo(a, b);
            pair.setHalves(a, b);
            pair.margin = motion.margin;
            pair.latestTime = motion.latestTime;
        }

        // Sets the pair's time to when the boxes first touch, if they do.
        private function writeTime(areTouching:Boolean, pair:BoxPair):void
        {
            pair.time = areTouching ? Math.min(_times.timeOfImpact, _times.latestTime) : RelativeMotion.NEVER;
        }

        // Narrows the interval by the faces of both. Returns whether anything is left.
        private function narrowByFaces(pair:BoxPair):Boolean
        {
            var axes:BoxAxes = pair.axes;
            var fromX:Number = pair.offsetX;
            var fromY:Number = pair.offsetY;
            var fromZ:Number = pair.offsetZ;
            var moveX:Number = pair.motionX;
            var moveY:Number = pair.motionY;
            var moveZ:Number = pair.motionZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            return narrow(pair, fromX, moveX, aHalfX + bHalfX * axes.abs00 + bHalfY * axes.abs01 + bHalfZ * axes.abs02, 1)
                && narrow(pair, fromY, moveY, aHalfY + bHalfX * axes.abs10 + bHalfY * axes.abs11 + bHalfZ * axes.abs12, 1)
                && narrow(pair, fromZ, moveZ, aHalfZ + bHalfX * axes.abs20 + bHalfY * axes.abs21 + bHalfZ * axes.abs22, 1)
                && narrow(pair, fromX * axes.m00 + fromY * axes.m10 + fromZ * axes.m20, axes.m00 * moveX + axes.m10 * moveY + axes.m20 * moveZ,
                    bHalfX + aHalfX * axes.abs00 + aHalfY * axes.abs10 + aHalfZ * axes.abs20, 1)
                && narrow(pair, fromX * axes.m01 + fromY * axes.m11 + fromZ * axes.m21, axes.m01 * moveX + axes.m11 * moveY + axes.m21 * moveZ,
                    bHalfY + aHalfX * axes.abs01 + aHalfY * axes.abs11 + aHalfZ * axes.abs21, 1)
                && narrow(pair, fromX * axes.m02 + fromY * axes.m12 + fromZ * axes.m22, axes.m02 * moveX + axes.m12 * moveY + axes.m22 * moveZ,
                    bHalfZ + aHalfX * axes.abs02 + aHalfY * axes.abs12 + aHalfZ * axes.abs22, 1);
        }

        // Narrows the interval by an axis, if it is longer than rounding. Returns whether anything is left. @param size at least the length of the axis
        private function narrow(pair:BoxPair, offset:Number, speed:Number, halfExtents:Number, size:Number):Boolean
        {
            var times:ContactInterval = _times;
            times.offset = offset;
            times.speed = speed;
            times.halfExtents = halfExtents;
            times.margin = pair.margin * size;
            return !(size > SHORTEST) || times.narrow();
        }

        // Narrows the interval by the edges of both. Returns whether anything is left. The boxes are projected in full on the cross product of an edge of
        // each. So even a short cross product of nearly parallel edges is an axis like any other. The test uses no identity between axes, because
        // rounding would break it.
        private function narrowByEdges(pair:BoxPair):Boolean
        {
            var axes:BoxAxes = pair.axes;
            var edges:Vector.<Number> = _edges;
            edges[0] = axes.m00;
            edges[1] = axes.m10;
            edges[2] = axes.m20;
            edges[3] = axes.m01;
            edges[4] = axes.m11;
            edges[5] = axes.m21;
            edges[6] = axes.m02;
            edges[7] = axes.m12;
            edges[8] = axes.m22;
            var halves:Vector.<Number> = _halves;
            for (var i:int = 0; i < 3; i++)
            {
                halves[i] = pair.bHalfX * edges[i];
                halves[int(i + 3)] = pair.bHalfY * edges[int(i + 3)];
                halves[int(i + 6)] = pair.bHalfZ * edges[int(i + 6)];
            }
            return narrowAcross(pair, 0, 3, 6) && narrowAcross(pair, 3, 6, 0) && narrowAcross(pair, 6, 0, 3);
        }

        // Narrows the interval by the cross products of edge p of b and the three edges of a, which are the coordinate axes. q and r are b's other edges.
        // All three are indices into the lists of edges. Returns whether anything is left.
        private function narrowAcross(pair:BoxPair, p:int, q:int, r:int):Boolean
        {
            var edges:Vector.<Number> = _edges;
            var halves:Vector.<Number> = _halves;
            var pX:Number = edges[p];
            var pY:Number = edges[int(p + 1)];
            var pZ:Number = edges[int(p + 2)];
            var qX:Number = halves[q];
            var qY:Number = halves[int(q + 1)];
            var qZ:Number = halves[int(q + 2)];
            var rX:Number = halves[r];
            var rY:Number = halves[int(r + 1)];
            var rZ:Number = halves[int(r + 2)];
            var sizeX:Number = Math.abs(pX);
            var sizeY:Number = Math.abs(pY);
            var sizeZ:Number = Math.abs(pZ);
            return narrow(pair, pair.offsetZ * pY - pair.offsetY * pZ, pair.motionZ * pY - pair.motionY * pZ,
                    pair.aHalfY * sizeZ + pair.aHalfZ * sizeY + Math.abs(qZ * pY - qY * pZ) + Math.abs(rZ * pY - rY * pZ), sizeY + sizeZ)
                && narrow(pair, pair.offsetX * pZ - pair.offsetZ * pX, pair.motionX * pZ - pair.motionZ * pX,
                    pair.aHalfZ * sizeX + pair.aHalfX * sizeZ + Math.abs(qX * pZ - qZ * pX) + Math.abs(rX * pZ - rZ * pX), sizeX + sizeZ)
                && narrow(pair, pair.offsetY * pX - pair.offsetX * pY, pair.motionY * pX - pair.motionX * pY,
                    pair.aHalfX * sizeY + pair.aHalfY * sizeX + Math.abs(qY * pX - qX * pY) + Math.abs(rY * pX - rX * pY), sizeX + sizeY);
        }
    }
}
