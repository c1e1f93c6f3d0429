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
        public var start:Vector3D = new Vector3D();

        /** The vector from its start to its end. */
        public var along:Vector3D = new Vector3D();

        /** Where the segment's closest point is: from 0 at its start to 1 at its end. */
        public var fraction:Number = 0;

        /** Whether a part of the segment is inside of all slabs of the box that it crosses. Slabs parallel to the segment are not tested. */
        public var isInside:Boolean = false;

        /** Sets the axis of a capsule. */
        public function setTo(capsule:Capsule, box:Box):void
        {
            var from:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var center:Vector3D = box.center;
            var fromX:Number = from.x - center.x;
            var fromY:Number = from.y - center.y;
            var fromZ:Number = from.z - center.z;
            var toX:Number = end.x - from.x;
            var toY:Number = end.y - from.y;
            var toZ:Number = end.z - from.z;
            var axis:Vector3D = box.axisX;
            start.x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along.x = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisY;
            start.y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along.y = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisZ;
            start.z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along.z = axis.x * toX + axis.y * toY + axis.z * toZ;
        }

        /** Moves the segment to where the capsule is at its motion's time. */
        public function move(box:Box, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            start.x += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            start.x += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            start.y += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            start.y += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            start.z += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
            start.z += time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
        }

        /** Finds <code>fraction</code> and <code>isInside</code>. First it finds where the segment's line enters and leaves each slab of the box. */
        public function findClosest(box:Box):void
        {
            var px:Number = start.x;
            var py:Number = start.y;
            var pz:Number = start.z;
            var ux:Number = along.x;
            var uy:Number = along.y;
            var uz:Number = along.z;
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
            var least:Number = Tolerances.DIRECTION * (Math.abs(along.x) + Math.abs(along.y) + Math.abs(along.z));
            var begin:Number = 0;
            var end:Number = 1;
            if (Math.abs(along.x) > least)
            {
                var half:Number = along.x < 0 ? -box.halfX : box.halfX;
                begin = Math.max(begin, (-half - start.x) / along.x);
                end = Math.min(end, (half - start.x) / along.x);
            }
            if (Math.abs(along.y) > least)
            {
                half = along.y < 0 ? -box.halfY : box.halfY;
                begin = Math.max(begin, (-half - start.y) / along.y);
                end = Math.min(end, (half - start.y) / along.y);
            }
            if (Math.abs(along.z) > least)
            {
                half = along.z < 0 ? -box.halfZ : box.halfZ;
                begin = Math.max(begin, (-half - start.z) / along.z);
                end = Math.min(end, (half - start.z) / along.z);
            }
            return begin < end ? (begin + end) / 2 : fraction;
        }
    }
}
