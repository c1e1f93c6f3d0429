package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.RelativeMotion;

    /**
     * A capsule's axis as seen from a box, and its point that is nearest to the box. All numbers are in the box's axes, mirrored so that no component
     * of the segment is negative. Its fields are read only.
     *
     * <p>The squared distance to the box is convex along the segment, and quadratic between the points where the segment crosses the planes of
     * the box's faces. So its minimum has a closed form.</p>
     */
    internal final class BoxSegment
    {
        /** For <code>capsuleBox()</code>. */
        public static const STANDING:BoxSegment = new BoxSegment();

        /** The segment's start, as seen from the box's middle. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The vector from its start to its end. */
        public var alongX:Number = 0;
        public var alongY:Number = 0;
        public var alongZ:Number = 0;

        /** -1 for each axis that is mirrored, 1 for the others. */
        public var signX:int = 1;
        public var signY:int = 1;
        public var signZ:int = 1;

        /**
         * The place on the segment's line that is nearest to the box, as all places from 0 at the segment's start to 1 at its end. It may be beyond the
         * ends. If the line passes through the box, it is where it has entered all slabs.
         */
        public var nearest:Number = 0;

        /** Where the line has entered all slabs of the box, and where it leaves the first one. It passes through the box if that is not before. */
        public var lastIn:Number = 0;
        public var firstOut:Number = 0;

        /** Sets the axis of a capsule. */
        public function setTo(capsule:Capsule, box:Box):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var middle:Vector3D = box.center;
            var fromX:Number = start.x - middle.x;
            var fromY:Number = start.y - middle.y;
            var fromZ:Number = start.z - middle.z;
            var toX:Number = end.x - start.x;
            var toY:Number = end.y - start.y;
            var toZ:Number = end.z - start.z;
            var axis:Vector3D = box.axisX;
            var along:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            signX = along < 0 ? -1 : 1;
            alongX = signX * along;
            x = signX * (axis.x * fromX + axis.y * fromY + axis.z * fromZ);
            axis = box.axisY;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            signY = along < 0 ? -1 : 1;
            alongY = signY * along;
            y = signY * (axis.x * fromX + axis.y * fromY + axis.z * fromZ);
            axis = box.axisZ;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            signZ = along < 0 ? -1 : 1;
            alongZ = signZ * along;
            z = signZ * (axis.x * fromX + axis.y * fromY + axis.z * fromZ);
        }

        /** Moves the segment to where the capsule is at its motion's time. */
        public function move(box:Box, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            x += signX * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            x += time * (signX * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
            axis = box.axisY;
            y += signY * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            y += time * (signY * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
            axis = box.axisZ;
            z += signZ * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            z += time * (signZ * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
        }

        /**
         * Finds <code>nearest</code>, <code>lastIn</code> and <code>firstOut</code>. First it finds where the line enters and leaves each slab of the box.
         */
        public function findNearest(box:Box):void
        {
            var px:Number = x;
            var py:Number = y;
            var pz:Number = z;
            var dx:Number = alongX;
            var dy:Number = alongY;
            var dz:Number = alongZ;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            var inX:Number = dx > 0 ? (-halfX - px) / dx : -Infinity;
            var outX:Number = dx > 0 ? (halfX - px) / dx : Infinity;
            var inY:Number = dy > 0 ? (-halfY - py) / dy : -Infinity;
            var outY:Number = dy > 0 ? (halfY - py) / dy : Infinity;
            var inZ:Number = dz > 0 ? (-halfZ - pz) / dz : -Infinity;
            var outZ:Number = dz > 0 ? (halfZ - pz) / dz : Infinity;
            lastIn = inX > inY ? inX : inY;
            lastIn = lastIn > inZ ? lastIn : inZ;
            firstOut = outX < outY ? outX : outY;
            firstOut = firstOut < outZ ? firstOut : outZ;
            var share:Number = lastIn;
            if (lastIn > firstOut)
            {
                // The line misses the box: it leaves one slab before it enters another, and is closest between these two places.
                // These two slabs count. The third slab also counts if the line is outside of it at the minimum found without it.
                var isOnX:Boolean = outX == firstOut || inX == lastIn;
                var isOnY:Boolean = outY == firstOut || inY == lastIn;
                var isOnZ:Boolean = outZ == firstOut || inZ == lastIn;
                var slope:Number = 0;
                var curvature:Number = 0;
                var beyond:Number;
                if (isOnX)
                {
                    beyond = outX == firstOut ? px - halfX : px + halfX;
                    slope = dx * beyond;
                    curvature = dx * dx;
                }
                if (isOnY)
                {
                    beyond = outY == firstOut ? py - halfY : py + halfY;
                    slope += dy * beyond;
                    curvature += dy * dy;
                }
                if (isOnZ)
                {
                    beyond = outZ == firstOut ? pz - halfZ : pz + halfZ;
                    slope += dz * beyond;
                    curvature += dz * dz;
                }
                share = -slope / curvature;
                if (!isOnX && (share < inX || share > outX))
                {
                    beyond = share < inX ? px + halfX : px - halfX;
                    share = -(slope + dx * beyond) / (curvature + dx * dx);
                }
                else if (!isOnY && (share < inY || share > outY))
                {
                    beyond = share < inY ? py + halfY : py - halfY;
                    share = -(slope + dy * beyond) / (curvature + dy * dy);
                }
                else if (!isOnZ && (share < inZ || share > outZ))
                {
                    beyond = share < inZ ? pz + halfZ : pz - halfZ;
                    share = -(slope + dz * beyond) / (curvature + dz * dz);
                }
            }
            nearest = share;
        }
    }
}
