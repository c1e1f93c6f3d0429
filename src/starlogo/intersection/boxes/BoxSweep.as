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
        private static const STANDING:BoxSweep = new BoxSweep();

        // The directions of b's edges, and half of each edge as a vector: along axisX, axisY, axisZ.
        private var _edges:Vector.<Number> = new Vector.<Number>(9, true);
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        private var _times:ContactInterval = new ContactInterval();
        private var _axisMotion:AxisMotion = new AxisMotion();

        // The pair of two boxes that are given as structures.
        private var _boxes:BoxPair = new BoxPair();

        /**
         * Whether two boxes touch where they stand. It takes longer than <code>boxBox()</code>, but its axes across edges do not cancel if the edges
         * are nearly parallel.
         */
        public static function areTouching(a:Box, b:Box):Boolean
        {
            var pair:BoxPair = STANDING._boxes;
            setPair(a, b, RelativeMotion.NONE, pair);
            STANDING.findTime(pair);
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
            findTime(_boxes);
            motion.time = _boxes.time;
        }

        /** Sets the pair's time to the first at which the boxes touch. It is NEVER if it is after the latest time. */
        public function findTime(pair:BoxPair):void
        {
            _times.begin(pair.latest);
            writeTime(narrowByFaces(pair) && narrowByEdges(pair), pair);
        }

        /**
         * Sets the pair's time to the first from which no face separates the boxes. The boxes touch at that time or later. It is NEVER if it is
         * after the latest time.
         */
        public function findTimeOfFaces(pair:BoxPair):void
        {
            _times.begin(pair.latest);
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
            pair.tolerance = motion.margin;
            pair.latest = motion.latest;
        }

        // Sets the pair's time to when the boxes first touch, if they do.
        private function writeTime(areTouching:Boolean, pair:BoxPair):void
        {
            pair.time = areTouching ? Math.min(_times.touch, _times.last) : RelativeMotion.NEVER;
        }

        // Narrows the interval by the faces of both. Returns whether anything is left.
        private function narrowByFaces(pair:BoxPair):Boolean
        {
            var times:ContactInterval = _times;
            var axes:BoxAxes = pair.axes;
            var axisMotion:AxisMotion = _axisMotion;
            axisMotion.tolerance = pair.tolerance;
            var fromX:Number = pair.offsetX;
            var fromY:Number = pair.offsetY;
            var fromZ:Number = pair.offsetZ;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            axisMotion.offset = fromX;
            axisMotion.travel = pair.motionX;
            axisMotion.halfExtents = pair.aHalfX + bHalfX * axes.abs00 + bHalfY * axes.abs01 + bHalfZ * axes.abs02;
            if (!times.narrow(axisMotion))
            {
                return false;
            }
            axisMotion.offset = fromY;
            axisMotion.travel = pair.motionY;
            axisMotion.halfExtents = pair.aHalfY + bHalfX * axes.abs10 + bHalfY * axes.abs11 + bHalfZ * axes.abs12;
            if (!times.narrow(axisMotion))
            {
                return false;
            }
            axisMotion.offset = fromZ;
            axisMotion.travel = pair.motionZ;
            axisMotion.halfExtents = pair.aHalfZ + bHalfX * axes.abs20 + bHalfY * axes.abs21 + bHalfZ * axes.abs22;
            if (!times.narrow(axisMotion))
            {
                return false;
            }
            axisMotion.offset = fromX * axes.m00 + fromY * axes.m10 + fromZ * axes.m20;
            axisMotion.travel = axes.m00 * pair.motionX + axes.m10 * pair.motionY + axes.m20 * pair.motionZ;
            axisMotion.halfExtents = bHalfX + pair.aHalfX * axes.abs00 + pair.aHalfY * axes.abs10 + pair.aHalfZ * axes.abs20;
            if (!times.narrow(axisMotion))
            {
                return false;
            }
            axisMotion.offset = fromX * axes.m01 + fromY * axes.m11 + fromZ * axes.m21;
            axisMotion.travel = axes.m01 * pair.motionX + axes.m11 * pair.motionY + axes.m21 * pair.motionZ;
            axisMotion.halfExtents = bHalfY + pair.aHalfX * axes.abs01 + pair.aHalfY * axes.abs11 + pair.aHalfZ * axes.abs21;
            if (!times.narrow(axisMotion))
            {
                return false;
            }
            axisMotion.offset = fromX * axes.m02 + fromY * axes.m12 + fromZ * axes.m22;
            axisMotion.travel = axes.m02 * pair.motionX + axes.m12 * pair.motionY + axes.m22 * pair.motionZ;
            axisMotion.halfExtents = bHalfZ + pair.aHalfX * axes.abs02 + pair.aHalfY * axes.abs12 + pair.aHalfZ * axes.abs22;
            return times.narrow(axisMotion);
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
            var times:ContactInterval = _times;
            var axisMotion:AxisMotion = _axisMotion;
            var halves:Vector.<Number> = _halves;
            var pX:Number = _edges[p];
            var pY:Number = _edges[int(p + 1)];
            var pZ:Number = _edges[int(p + 2)];
            var qX:Number = halves[q];
            var qY:Number = halves[int(q + 1)];
            var qZ:Number = halves[int(q + 2)];
            var rX:Number = halves[r];
            var rY:Number = halves[int(r + 1)];
            var rZ:Number = halves[int(r + 2)];
            var sizeX:Number = pX < 0 ? -pX : pX;
            var sizeY:Number = pY < 0 ? -pY : pY;
            var sizeZ:Number = pZ < 0 ? -pZ : pZ;
            var alongQ:Number = qZ * pY - qY * pZ;
            alongQ = alongQ < 0 ? -alongQ : alongQ;
            var alongR:Number = rZ * pY - rY * pZ;
            alongR = alongR < 0 ? -alongR : alongR;
            if (sizeY + sizeZ > SHORTEST)
            {
                axisMotion.offset = pair.offsetZ * pY - pair.offsetY * pZ;
                axisMotion.travel = pair.motionZ * pY - pair.motionY * pZ;
                axisMotion.halfExtents = pair.aHalfY * sizeZ + pair.aHalfZ * sizeY + alongQ + alongR;
                axisMotion.tolerance = pair.tolerance * (sizeY + sizeZ);
                if (!times.narrow(axisMotion))
                {
                    return false;
                }
            }
            alongQ = qX * pZ - qZ * pX;
            alongQ = alongQ < 0 ? -alongQ : alongQ;
            alongR = rX * pZ - rZ * pX;
            alongR = alongR < 0 ? -alongR : alongR;
            if (sizeX + sizeZ > SHORTEST)
            {
                axisMotion.offset = pair.offsetX * pZ - pair.offsetZ * pX;
                axisMotion.travel = pair.motionX * pZ - pair.motionZ * pX;
                axisMotion.halfExtents = pair.aHalfZ * sizeX + pair.aHalfX * sizeZ + alongQ + alongR;
                axisMotion.tolerance = pair.tolerance * (sizeX + sizeZ);
                if (!times.narrow(axisMotion))
                {
                    return false;
                }
            }
            if (!(sizeX + sizeY > SHORTEST))
            {
                return true;
            }
            alongQ = qY * pX - qX * pY;
            alongQ = alongQ < 0 ? -alongQ : alongQ;
            alongR = rY * pX - rX * pY;
            alongR = alongR < 0 ? -alongR : alongR;
            axisMotion.offset = pair.offsetY * pX - pair.offsetX * pY;
            axisMotion.travel = pair.motionY * pX - pair.motionX * pY;
            axisMotion.halfExtents = pair.aHalfX * sizeY + pair.aHalfY * sizeX + alongQ + alongR;
            axisMotion.tolerance = pair.tolerance * (sizeX + sizeY);
            return times.narrow(axisMotion);
        }
    }
}
