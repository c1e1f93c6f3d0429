package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.BoxAxes;

    /**
     * Finds when two moving boxes first touch, by separating axes over time. Boxes touch while no axis separates them. Each axis gives an
     * interval of time during which it does not separate them. The boxes first touch when the last interval begins, if that is before the
     * first one ends.
     *
     * <p>All numbers are in the axes of box a. Many pairs of boxes may have the same rotation and motion. Then <code>axes</code> is set once
     * for all of them.</p>
     *
     * @private
     */
    public final class BoxSweep
    {
        /** The axes of b. */
        public var axes:BoxAxes = new BoxAxes();

        /** The motion of b from time 0 to 1 as seen from a, in a's axes. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The gap across which the boxes still touch. */
        public var tolerance:Number = 0;

        /** The vector from a's middle to b's at time 0, in a's axes. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The half-extents of a. */
        public var aX:Number = 0;
        public var aY:Number = 0;
        public var aZ:Number = 0;

        /** The half-extents of b. */
        public var bX:Number = 0;
        public var bY:Number = 0;
        public var bZ:Number = 0;

        /** The latest time that counts. */
        public var latest:Number = 1;

        /** The result: the time from which the axes tried do not separate the boxes, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;

        // The directions of b's edges, and half of each edge as a vector: along axisX, axisY, axisZ.
        private var _edges:Vector.<Number> = new Vector.<Number>(9, true);
        private var _halves:Vector.<Number> = new Vector.<Number>(9, true);

        private var _times:ContactInterval = new ContactInterval();
        private var _along:AxisMotion = new AxisMotion();

        /**
         * Finds when a moving box first touches another box. Sets all that <code>meetFaces()</code> needs, except for the latest time.
         *
         * @param a moves; half-extents may be 0
         * @param b in the space of a; half-extents may be 0
         * @param motion the motion of a; receives the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(a:Box, b:Box, motion:RelativeMotion):void
        {
            var edgeX:Vector3D = b.axisX;
            var edgeY:Vector3D = b.axisY;
            var edgeZ:Vector3D = b.axisZ;
            var moveX:Number = motion.x;
            var moveY:Number = motion.y;
            var moveZ:Number = motion.z;
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            var relative:BoxAxes = axes;
            var axis:Vector3D = a.axisX;
            relative.xx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            relative.xy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            relative.xz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionX = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisY;
            relative.yx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            relative.yy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            relative.yz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionY = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisZ;
            relative.zx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            relative.zy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            relative.zz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            motionZ = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            relative.measureAxes();
            aX = a.halfX;
            aY = a.halfY;
            aZ = a.halfZ;
            bX = b.halfX;
            bY = b.halfY;
            bZ = b.halfZ;
            motion.findMargin();
            tolerance = motion.margin;
            meetFaces();
            if (time != RelativeMotion.NEVER)
            {
                meetEdges();
            }
            motion.time = time;
        }

        /**
         * Finds the time from which no face separates two boxes. The boxes touch at that time or later. It is NEVER if it is after the
         * latest time.
         */
        public function meetFaces():void
        {
            time = RelativeMotion.NEVER;
            var times:ContactInterval = _times;
            var b:BoxAxes = axes;
            var along:AxisMotion = _along;
            times.begin(latest);
            along.tolerance = tolerance;
            var fromX:Number = x;
            var fromY:Number = y;
            var fromZ:Number = z;
            var halfX:Number = bX;
            var halfY:Number = bY;
            var halfZ:Number = bZ;
            along.at = fromX;
            along.speed = motionX;
            along.radius = aX + halfX * b.absXx + halfY * b.absXy + halfZ * b.absXz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromY;
            along.speed = motionY;
            along.radius = aY + halfX * b.absYx + halfY * b.absYy + halfZ * b.absYz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromZ;
            along.speed = motionZ;
            along.radius = aZ + halfX * b.absZx + halfY * b.absZy + halfZ * b.absZz;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xx + fromY * b.yx + fromZ * b.zx;
            along.speed = b.xx * motionX + b.yx * motionY + b.zx * motionZ;
            along.radius = halfX + aX * b.absXx + aY * b.absYx + aZ * b.absZx;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xy + fromY * b.yy + fromZ * b.zy;
            along.speed = b.xy * motionX + b.yy * motionY + b.zy * motionZ;
            along.radius = halfY + aX * b.absXy + aY * b.absYy + aZ * b.absZy;
            if (!times.narrow(along))
            {
                return;
            }
            along.at = fromX * b.xz + fromY * b.yz + fromZ * b.zz;
            along.speed = b.xz * motionX + b.yz * motionY + b.zz * motionZ;
            along.radius = halfZ + aX * b.absXz + aY * b.absYz + aZ * b.absZz;
            if (times.narrow(along))
            {
                time = times.touch < times.last ? times.touch : times.last;
            }
        }

        /**
         * Finds when the boxes touch. Call meetFaces first, with the same boxes.
         *
         * <p>The boxes are projected in full on the cross product of an edge of each. So even a short cross product of nearly parallel
         * edges is an axis like any other. The test uses no identity between axes, because rounding would break it.</p>
         */
        public function meetEdges():void
        {
            var b:BoxAxes = axes;
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
                halves[i] = bX * edges[i];
                halves[int(i + 3)] = bY * edges[int(i + 3)];
                halves[int(i + 6)] = bZ * edges[int(i + 6)];
            }
            var areTouching:Boolean = narrowAcross(0, 3, 6) && narrowAcross(3, 6, 0) && narrowAcross(6, 0, 3);
            time = areTouching ? (_times.touch < _times.last ? _times.touch : _times.last) : RelativeMotion.NEVER;
        }

        // Narrows the interval by the cross products of edge p of b and the edges of a. q and r are b's other edges. Returns whether anything is left.
        private function narrowAcross(p:int, q:int, r:int):Boolean
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
                along.at = z * pY - y * pZ;
                along.speed = motionZ * pY - motionY * pZ;
                along.radius = aY * sizeZ + aZ * sizeY + alongQ + alongR;
                along.tolerance = tolerance * (sizeY + sizeZ);
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
                along.at = x * pZ - z * pX;
                along.speed = motionX * pZ - motionZ * pX;
                along.radius = aZ * sizeX + aX * sizeZ + alongQ + alongR;
                along.tolerance = tolerance * (sizeX + sizeZ);
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
            along.at = y * pX - x * pY;
            along.speed = motionY * pX - motionX * pY;
            along.radius = aX * sizeY + aY * sizeX + alongQ + alongR;
            along.tolerance = tolerance * (sizeX + sizeY);
            return times.narrow(along);
        }

        // Below this length a cross product is only rounding, because the edges are parallel (Tolerances.PARALLEL).
        private static const SHORTEST:Number = Math.sqrt(Tolerances.PARALLEL);
    }
}
