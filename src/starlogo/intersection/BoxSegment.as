package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * The point of a capsule's segment that is nearest to a box, for a capsule in many places: all in the box's axes, mirrored so that
     * the segment points up each of them.
     */
    public final class BoxSegment
    {
        /** For tests that are over before the next begins. */
        public static const SCRATCH:BoxSegment = new BoxSegment();

        /** From the box's middle to the segment's start, where the capsule stands. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** From the segment's start to its end, not negative. */
        public var alongX:Number;

        /** @copy #alongX */
        public var alongY:Number;

        /** @copy #alongX */
        public var alongZ:Number;

        /** The way that was turned last, in these axes. */
        public var wayX:Number;

        /** @copy #wayX */
        public var wayY:Number;

        /** @copy #wayX */
        public var wayZ:Number;

        private var _box:Box;
        private var _signX:Number;
        private var _signY:Number;
        private var _signZ:Number;

        /** No segment yet. */
        public function BoxSegment()
        {
        }

        /** Takes a capsule's segment and a box. */
        public function relate(capsule:Capsule, box:Box):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            _box = box;
            _signX = _signY = _signZ = 1;
            turn(end.x - start.x, end.y - start.y, end.z - start.z);
            _signX = wayX < 0 ? -1 : 1;
            _signY = wayY < 0 ? -1 : 1;
            _signZ = wayZ < 0 ? -1 : 1;
            alongX = _signX * wayX;
            alongY = _signY * wayY;
            alongZ = _signZ * wayZ;
            var middle:Vector3D = box.center;
            turn(start.x - middle.x, start.y - middle.y, start.z - middle.z);
            x = wayX;
            y = wayY;
            z = wayZ;
        }

        /** Turns a way into these axes. */
        public function turn(x:Number, y:Number, z:Number):void
        {
            var axis:Vector3D = _box.axisX;
            wayX = _signX * (axis.x * x + axis.y * y + axis.z * z);
            axis = _box.axisY;
            wayY = _signY * (axis.x * x + axis.y * y + axis.z * z);
            axis = _box.axisZ;
            wayZ = _signZ * (axis.x * x + axis.y * y + axis.z * z);
        }

        /** Points a normal along a way in these axes. */
        public function turnBack(x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var axisX:Vector3D = _box.axisX;
            var axisY:Vector3D = _box.axisY;
            var axisZ:Vector3D = _box.axisZ;
            x *= _signX;
            y *= _signY;
            z *= _signZ;
            out.pointAlong(x * axisX.x + y * axisY.x + z * axisZ.x, x * axisX.y + y * axisY.y + z * axisZ.y,
                    x * axisX.z + y * axisY.z + z * axisZ.z);
        }

        /** Lets go of the box. */
        public function end():void
        {
            _box = null;
        }

        /**
         * Where on the segment, from 0 to 1, the point is that is nearest to the box; of several, one in their midst. Along the segment
         * the squared distance is convex, and quadratic between the planes of the box's faces; see capsuleBox.
         *
         * @param px from the box's middle to the segment's start, in these axes
         * @param py likewise
         * @param pz likewise
         */
        public function nearest(px:Number, py:Number, pz:Number, hx:Number, hy:Number, hz:Number):Number
        {
            var dx:Number = alongX;
            var dy:Number = alongY;
            var dz:Number = alongZ;
            // Where the segment's line enters and leaves each slab of the box, and all of them.
            var inX:Number = -Infinity;
            var outX:Number = Infinity;
            if (dx > 0)
            {
                inX = (-hx - px) / dx;
                outX = (hx - px) / dx;
            }
            var inY:Number = -Infinity;
            var outY:Number = Infinity;
            if (dy > 0)
            {
                inY = (-hy - py) / dy;
                outY = (hy - py) / dy;
            }
            var inZ:Number = -Infinity;
            var outZ:Number = Infinity;
            if (dz > 0)
            {
                inZ = (-hz - pz) / dz;
                outZ = (hz - pz) / dz;
            }
            var lastIn:Number = inX > inY ? inX : inY;
            lastIn = lastIn > inZ ? lastIn : inZ;
            var firstOut:Number = outX < outY ? outX : outY;
            firstOut = firstOut < outZ ? firstOut : outZ;
            if (lastIn <= firstOut)
            {
                lastIn = lastIn > 0 ? (lastIn < 1 ? lastIn : 1) : 0;
                firstOut = firstOut > 0 ? (firstOut < 1 ? firstOut : 1) : 0;
                return (lastIn + firstOut) / 2;
            }

            // The line has left one slab before it enters another, and comes closest in between. Those two count; the third does where,
            // at what would be the minimum without it, it is outside as well.
            var slope:Number = 0;
            var curvature:Number = 0;
            if (outX == firstOut)
            {
                slope = dx * (px - hx);
                curvature = dx * dx;
            }
            else if (inX == lastIn)
            {
                slope = dx * (px + hx);
                curvature = dx * dx;
            }
            if (outY == firstOut)
            {
                slope += dy * (py - hy);
                curvature += dy * dy;
            }
            else if (inY == lastIn)
            {
                slope += dy * (py + hy);
                curvature += dy * dy;
            }
            if (outZ == firstOut)
            {
                slope += dz * (pz - hz);
                curvature += dz * dz;
            }
            else if (inZ == lastIn)
            {
                slope += dz * (pz + hz);
                curvature += dz * dz;
            }
            var t:Number = -slope / curvature;
            var face:Number;
            if (outX != firstOut && inX != lastIn && (t < inX || t > outX))
            {
                face = t < inX ? px + hx : px - hx;
                t = -(slope + dx * face) / (curvature + dx * dx);
            }
            else if (outY != firstOut && inY != lastIn && (t < inY || t > outY))
            {
                face = t < inY ? py + hy : py - hy;
                t = -(slope + dy * face) / (curvature + dy * dy);
            }
            else if (outZ != firstOut && inZ != lastIn && (t < inZ || t > outZ))
            {
                face = t < inZ ? pz + hz : pz - hz;
                t = -(slope + dz * face) / (curvature + dz * dz);
            }
            // false for NaN too
            return t > 0 ? (t < 1 ? t : 1) : 0;
        }
    }
}
