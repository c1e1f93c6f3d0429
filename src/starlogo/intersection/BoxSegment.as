package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * A capsule's axis as seen from a box, in the box's axes. It finds the point of the axis that is closest to the box. Its fields are read only.
     *
     * <p>The squared distance to the box is convex along the segment, and quadratic between the points where the segment crosses the planes of
     * the box's faces. So its minimum has a closed form.</p>
     */
    internal final class BoxSegment
    {
        /** The segment that <code>capsuleBox()</code> sets, whose capsule stands. */
        public static const SCRATCH:BoxSegment = new BoxSegment();

        /** The segment's start as seen from the box's middle, the vector from its start to its end, and the half-extents of the box: three numbers each. */
        public var start:Vector.<Number> = new Vector.<Number>(3, true);
        public var along:Vector.<Number> = new Vector.<Number>(3, true);
        public var halves:Vector.<Number> = new Vector.<Number>(3, true);

        // Where the segment's line enters and leaves each slab of the box, as fractions of the segment. They are infinite if it is parallel to the slab.
        private var _enters:Vector.<Number> = new Vector.<Number>(3, true);
        private var _leaves:Vector.<Number> = new Vector.<Number>(3, true);

        /** Sets the axis of a capsule. */
        public function setTo(capsule:Capsule, box:Box):void
        {
            var from:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var fromX:Number = from.x - box.center.x;
            var fromY:Number = from.y - box.center.y;
            var fromZ:Number = from.z - box.center.z;
            var toX:Number = end.x - from.x;
            var toY:Number = end.y - from.y;
            var toZ:Number = end.z - from.z;
            var axis:Vector3D = box.axisX;
            start[0] = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along[0] = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisY;
            start[1] = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along[1] = axis.x * toX + axis.y * toY + axis.z * toZ;
            axis = box.axisZ;
            start[2] = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            along[2] = axis.x * toX + axis.y * toY + axis.z * toZ;
            halves[0] = box.halfX;
            halves[1] = box.halfY;
            halves[2] = box.halfZ;
        }

        /** Moves the axis to where the capsule is at its motion's time. */
        public function move(box:Box, motion:RelativeMotion):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                var axis:Vector3D = i == 0 ? box.axisX : i == 1 ? box.axisY : box.axisZ;
                start[i] += axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ;
                start[i] += motion.time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            }
        }

        /**
         * Finds the point that is closest to the box. First it finds where the segment's line enters and leaves each slab of the box.
         *
         * @param out receives its place and its fraction
         */
        public function findClosest(out:RoundGap):void
        {
            var lastIn:Number = -Infinity;
            var firstOut:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                var u:Number = along[i];
                // the line leaves the slab where it reaches this side
                var half:Number = u < 0 ? -halves[i] : halves[i];
                var enter:Number = u != 0 ? (-half - start[i]) / u : -Infinity;
                var leave:Number = u != 0 ? (half - start[i]) / u : Infinity;
                lastIn = enter > lastIn ? enter : lastIn;
                firstOut = leave < firstOut ? leave : firstOut;
                _enters[i] = enter;
                _leaves[i] = leave;
            }
            var closest:Number;
            if (lastIn <= firstOut)
            {
                var begin:Number = lastIn > 0 ? lastIn : 0;
                var end:Number = firstOut > 0 ? firstOut : 0;
                begin = begin < 1 ? begin : 1;
                end = end < 1 ? end : 1;
                closest = (begin + end) / 2;
            }
            else
            {
                // The line misses the box: it leaves one slab before it enters another, and is closest between these two places. How far it is outside
                // of these two slabs counts.
                var slope:Number = 0;
                var curvature:Number = 0;
                var third:int = -1;
                for (i = 0; i < 3; i++)
                {
                    u = along[i];
                    half = u < 0 ? -halves[i] : halves[i];
                    if (_leaves[i] == firstOut || _enters[i] == lastIn)
                    {
                        var beyond:Number = _leaves[i] == firstOut ? start[i] - half : start[i] + half;
                        slope += u * beyond;
                        curvature += u * u;
                    }
                    else
                    {
                        third = i;
                    }
                }
                closest = -slope / curvature;
                // The third slab also counts if the line is outside of it at the minimum found without it.
                if (third >= 0 && (closest < _enters[third] || closest > _leaves[third]))
                {
                    u = along[third];
                    half = u < 0 ? -halves[third] : halves[third];
                    beyond = closest < _enters[third] ? start[third] + half : start[third] - half;
                    closest = -(slope + u * beyond) / (curvature + u * u);
                }
                // The comparison is false for NaN too.
                closest = closest > 0 ? closest : 0;
                closest = closest < 1 ? closest : 1;
            }
            // A point inside of all slabs that the segment crosses may be anywhere in them. Rounding must not put it outside: a radius of 0 allows no error.
            var isInside:Boolean = lastIn <= firstOut && lastIn <= 1 && firstOut >= 0;
            out.place.x = isInside && along[0] != 0 ? 0 : start[0] + closest * along[0];
            out.place.y = isInside && along[1] != 0 ? 0 : start[1] + closest * along[1];
            out.place.z = isInside && along[2] != 0 ? 0 : start[2] + closest * along[2];
            out.fraction = closest;
        }

        /**
         * Moves the closest point of the segment to the middle of the part beside a face or an edge of the box, if the segment is parallel to it up to
         * rounding. All of that part is equally close.
         *
         * @param gap that of this segment and the box; its fraction changes
         */
        public function moveToMiddle(gap:RoundGap):void
        {
            var least:Number = Tolerances.DIRECTION * (Math.abs(along[0]) + Math.abs(along[1]) + Math.abs(along[2]));
            var begin:Number = 0;
            var end:Number = 1;
            for (var i:int = 0; i < 3; i++)
            {
                var u:Number = along[i];
                if (Math.abs(u) > least)
                {
                    var half:Number = u < 0 ? -halves[i] : halves[i];
                    begin = Math.max(begin, (-half - start[i]) / u);
                    end = Math.min(end, (half - start[i]) / u);
                }
            }
            gap.fraction = begin < end ? (begin + end) / 2 : gap.fraction;
        }
    }
}
