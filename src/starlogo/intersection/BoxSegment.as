package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * A capsule's axis as seen from a box, and its point that is nearest to the box. All numbers are in the box's axes. Its fields are read only.
     *
     * <p>The squared distance to the box is convex along the segment, and quadratic between the points where the segment crosses the planes of
     * the box's faces. So its minimum has a closed form.</p>
     */
    internal final class BoxSegment
    {
        /** The segment that <code>capsuleBox()</code> sets, of a capsule that stands. */
        public static const SCRATCH:BoxSegment = new BoxSegment();

        /** The segment's start, as seen from the box's middle. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The vector from its start to its end. */
        public var alongX:Number = 0;
        public var alongY:Number = 0;
        public var alongZ:Number = 0;

        /** Where the segment's closest point is: from 0 at its start to 1 at its end. */
        public var fraction:Number = 0;

        /** Whether a part of the segment is inside of all slabs of the box that it crosses. Slabs parallel to the segment are not tested. */
        public var isInside:Boolean = false;

        /** Sets the axis of a capsule. */
        public function setTo(capsule:Capsule, box:Box):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var center:Vector3D = box.center;
            var fromX:Number = start.x - center.x;
            var fromY:Number = start.y - center.y;
            var fromZ:Number = start.z - center.z;
            var toX:Number = end.x - start.x;
            var toY:Number = end.y - start.y;
            var toZ:Number = end.z - start.z;
            var axis:Vector3D = box.axisX;
            x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            alongX = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisY;
            y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            alongY = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisZ;
            z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            alongZ = axis.x * toX + axis.y * toY + axis.z * toZ;
        }

        /** Moves the segment to where the capsule is at its motion's time. */
        public function move(box:Box, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            x += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            x += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            y += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            y += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            z += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            z += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
        }

        /** Finds <code>fraction</code> and <code>isInside</code>. First it finds where the segment's line enters and leaves each slab of the box. */
        public function findClosest(box:Box):void
        {
            var px:Number = x;
            var py:Number = y;
            var pz:Number = z;
            var ux:Number = alongX;
            var uy:Number = alongY;
            var uz:Number = alongZ;
            // the half-extents, negative along axes that the segment runs against: it leaves a slab where it reaches them
            var halfX:Number = ux < 0 ? -box.halfX : box.halfX;
            var halfY:Number = uy < 0 ? -box.halfY : box.halfY;
            var halfZ:Number = uz < 0 ? -box.halfZ : box.halfZ;
            var inX:Number = ux != 0 ? (-halfX - px) / ux : -Infinity;
            var outX:Number = ux != 0 ? (halfX - px) / ux : Infinity;
            var inY:Number = uy != 0 ? (-halfY - py) / uy : -Infinity;
            var outY:Number = uy != 0 ? (halfY - py) / uy : Infinity;
            var inZ:Number = uz != 0 ? (-halfZ - pz) / uz : -Infinity;
            var outZ:Number = uz != 0 ? (halfZ - pz) / uz : Infinity;
            var lastIn:Number = inX > inY ? inX : inY;
            lastIn = lastIn > inZ ? lastIn : inZ;
            var firstOut:Number = outX < outY ? outX : outY;
            firstOut = firstOut < outZ ? firstOut : outZ;
            isInside = lastIn <= firstOut && lastIn <= 1 && firstOut >= 0;
            if (lastIn <= firstOut)
            {
                var begin:Number = lastIn > 0 ? lastIn : 0;
                var end:Number = firstOut > 0 ? firstOut : 0;
                begin = begin < 1 ? begin : 1;
                end = end < 1 ? end : 1;
                fraction = (begin + end) / 2;
                return;
            }
            // The line misses the box: it leaves one slab before it enters another, and is closest between these two places. How far it is outside of
            // these two slabs counts.
            var dx:Number = outX == firstOut || inX == lastIn ? ux : 0;
            var dy:Number = outY == firstOut || inY == lastIn ? uy : 0;
            var dz:Number = outZ == firstOut || inZ == lastIn ? uz : 0;
            var beyondX:Number = outX == firstOut ? px - halfX : px + halfX;
            var beyondY:Number = outY == firstOut ? py - halfY : py + halfY;
            var beyondZ:Number = outZ == firstOut ? pz - halfZ : pz + halfZ;
            var slope:Number = dx * beyondX + dy * beyondY + dz * beyondZ;
            var curvature:Number = dx * dx + dy * dy + dz * dz;
            var closest:Number = -slope / curvature;
            // The third slab also counts if the line is outside of it at the minimum found without it.
            if (dx == 0 && (closest < inX || closest > outX))
            {
                beyondX = closest < inX ? px + halfX : px - halfX;
                closest = -(slope + ux * beyondX) / (curvature + ux * ux);
            }
            else if (dy == 0 && (closest < inY || closest > outY))
            {
                beyondY = closest < inY ? py + halfY : py - halfY;
                closest = -(slope + uy * beyondY) / (curvature + uy * uy);
            }
            else if (dz == 0 && (closest < inZ || closest > outZ))
            {
                beyondZ = closest < inZ ? pz + halfZ : pz - halfZ;
                closest = -(slope + uz * beyondZ) / (curvature + uz * uz);
            }
            // The comparison is false for NaN too.
            closest = closest > 0 ? closest : 0;
            fraction = closest < 1 ? closest : 1;
        }

        /**
         * The middle of the closest points, as <code>findClosest()</code> found them. If the segment is parallel to a face or an edge up to rounding, all of
         * the part beside it is equally close, and it is the middle of that part.
         */
        public function middleIn(box:Box):Number
        {
            var least:Number = Tolerances.DIRECTION * (Math.abs(alongX) + Math.abs(alongY) + Math.abs(alongZ));
            var begin:Number = 0;
            var end:Number = 1;
            if (Math.abs(alongX) > least)
            {
                var half:Number = alongX < 0 ? -box.halfX : box.halfX;
                begin = Math.max(begin, (-half - x) / alongX);
                end = Math.min(end, (half - x) / alongX);
            }
            if (Math.abs(alongY) > least)
            {
                half = alongY < 0 ? -box.halfY : box.halfY;
                begin = Math.max(begin, (-half - y) / alongY);
                end = Math.min(end, (half - y) / alongY);
            }
            if (Math.abs(alongZ) > least)
            {
                half = alongZ < 0 ? -box.halfZ : box.halfZ;
                begin = Math.max(begin, (-half - z) / alongZ);
                end = Math.min(end, (half - z) / alongZ);
            }
            return begin < end ? (begin + end) / 2 : fraction;
        }
    }
}
