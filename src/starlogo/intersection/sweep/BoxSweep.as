package starlogo.intersection.sweep
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.BoxAxes;

    /**
     * Finds when two moving boxes first touch, by separating axes over time. Boxes touch while no axis separates them. Each axis gives an
     * interval of time during which it does not separate them. The boxes first touch when the last interval begins, if that is before the
     * first one ends.
     *
     * @private
     */
    public final class BoxSweep
    {
        // Below this length a cross product is only rounding, because the edges are parallel (Tolerances.PARALLEL).
        private static const SHORTEST:Number = Math.sqrt(Tolerances.PARALLEL);

        // The directions of b's edges, and half of each edge as a vector: along axisX, axisY, axisZ.
        private var _edges:Vector.<Number> = new Vector.<Number>(9, true);
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        private var _times:ContactInterval = new ContactInterval();
        private var _along:AxisMotion = new AxisMotion();

        /** Sets the pair's time to the first at which the boxes touch. */
        public function findTime(pair:BoxPairMotion):void
        {
            meetFaces(pair);
            if (pair.time != RelativeMotion.NEVER)
            {
                meetEdges(pair);
            }
        }

        /**
         * Sets the pair's time to the first from which no face separates the boxes. The boxes touch at that time or later. It is NEVER if it is
         * after the latest time.
         */
        public function meetFaces(pair:BoxPairMotion):void
        {
            pair.time = RelativeMotion.NEVER;
            var times:ContactInterval = _times;
            var b:BoxAxes = pair.axes;
            var along:AxisMotion = _along;
            times.begin(pair.latest);
            along.tolerance = pair.tolerance;
            var fromX:Number = pair.x;
            var fromY:Number = pair.y;
            var fromZ:Number = pair.z;
            var halfX:Number = pair.bX;
            var halfY:Number = pair.bY;
            var halfZ:Number = pair.bZ;
            along.at = fromX;
            along.speed = pair.motionX;
            along.radius = pair.aX + halfX * b.absXx + halfY * b.absXy + halfZ * b.absXz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromY;
            along.speed = pair.motionY;
            along.radius = pair.aY + halfX * b.absYx + halfY * b.absYy + halfZ * b.absYz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromZ;
            along.speed = pair.motionZ;
            along.radius = pair.aZ + halfX * b.absZx + halfY * b.absZy + halfZ * b.absZz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xx + fromY * b.yx + fromZ * b.zx;
            along.speed = b.xx * pair.motionX + b.yx * pair.motionY + b.zx * pair.motionZ;
            along.radius = halfX + pair.aX * b.absXx + pair.aY * b.absYx + pair.aZ * b.absZx;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xy + fromY * b.yy + fromZ * b.zy;
            along.speed = b.xy * pair.motionX + b.yy * pair.motionY + b.zy * pair.motionZ;
            along.radius = halfY + pair.aX * b.absXy + pair.aY * b.absYy + pair.aZ * b.absZy;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xz + fromY * b.yz + fromZ * b.zz;
            along.speed = b.xz * pair.motionX + b.yz * pair.motionY + b.zz * pair.motionZ;
            along.radius = halfZ + pair.aX * b.absXz + pair.aY * b.absYz + pair.aZ * b.absZz;
            if (times.narrow(along))
            {
                pair.time = times.touch < times.last ? times.touch : times.last;
            }
        }

        /**
         * Sets the pair's time to the first at which the boxes touch. Call meetFaces first, with the same pair.
         *
         * <p>The boxes are projected in full on the cross product of an edge of each. So even a short cross product of nearly parallel
         * edges is an axis like any other. The test uses no identity between axes, because rounding would break it.</p>
         */
        public function meetEdges(pair:BoxPairMotion):void
        {
            var b:BoxAxes = pair.axes;
            var edges:Vector.<Number> = _edges;
            edges[0] = b.xx;
            edges[1] = b.yx;
            edges[2] = b.zx;
            edges[3] = b.xy;
            edges[4] = b.yy;
            edges[5] = b.zy;
            edges[6] = b.xz;
            edges[7] = b.yz;
            edges[8] = b.zz;
            var halves:Vector.<Number> = _halves;
            for (var i:int = 0; i < 3; i++)
            {
                halves[i] = pair.bX * edges[i];
                halves[int(i + 3)] = pair.bY * edges[int(i + 3)];
                halves[int(i + 6)] = pair.bZ * edges[int(i + 6)];
            }
            var areTouching:Boolean = narrowAcross(pair, 0, 3, 6) && narrowAcross(pair, 3, 6, 0) && narrowAcross(pair, 6, 0, 3);
            pair.time = areTouching ? (_times.touch < _times.last ? _times.touch : _times.last) : RelativeMotion.NEVER;
        }

        // Narrows the interval by the cross products of edge p of b and the edges of a. q and r are b's other edges. Returns whether anything is left.
        private function narrowAcross(pair:BoxPairMotion, p:int, q:int, r:int):Boolean
        {
            var times:ContactInterval = _times;
            var along:AxisMotion = _along;
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
                along.at = pair.z * pY - pair.y * pZ;
                along.speed = pair.motionZ * pY - pair.motionY * pZ;
                along.radius = pair.aY * sizeZ + pair.aZ * sizeY + alongQ + alongR;
                along.tolerance = pair.tolerance * (sizeY + sizeZ);
                if (!times.narrow(along))
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
                along.at = pair.x * pZ - pair.z * pX;
                along.speed = pair.motionX * pZ - pair.motionZ * pX;
                along.radius = pair.aZ * sizeX + pair.aX * sizeZ + alongQ + alongR;
                along.tolerance = pair.tolerance * (sizeX + sizeZ);
                if (!times.narrow(along))
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
            along.at = pair.y * pX - pair.x * pY;
            along.speed = pair.motionY * pX - pair.motionX * pY;
            along.radius = pair.aX * sizeY + pair.aY * sizeX + alongQ + alongR;
            along.tolerance = pair.tolerance * (sizeX + sizeY);
            return times.narrow(along);
        }
    }
}
