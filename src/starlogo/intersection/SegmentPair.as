package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /** The axes of two capsules, or the centre of a sphere and the axis of a capsule, and their closest points. */
    internal final class SegmentPair
    {
        /** The pair that <code>capsuleCapsule()</code> sets, whose capsules stand, and its gap. */
        public static const SCRATCH:SegmentPair = new SegmentPair();
        public static const SCRATCH_GAP:CoreGap = new CoreGap();

        /** The axis of a, and the axis of b, each from its start to its end. All fields are read only. */
        public var u:Vector3D = new Vector3D();
        public var v:Vector3D = new Vector3D();

        /** The vector from v's start to u's. */
        public var offset:Vector3D = new Vector3D();

        /** Where u's closest point is: from 0 at its start to 1 at its end. <code>findClosest()</code> finds it. */
        public var fractionOfU:Number = 0;

        /** Sets the axes: that of a from its start to its end, and that of a capsule. */
        public function setTo(startA:Vector3D, endA:Vector3D, b:Capsule):void
        {
            var startB:Vector3D = b.start;
            var endB:Vector3D = b.end;
            u.x = endA.x - startA.x;
            u.y = endA.y - startA.y;
            u.z = endA.z - startA.z;
            v.x = endB.x - startB.x;
            v.y = endB.y - startB.y;
            v.z = endB.z - startB.z;
            offset.x = startA.x - startB.x;
            offset.y = startA.y - startB.y;
            offset.z = startA.z - startB.z;
        }

        /** Moves u to where a is at its motion's time. */
        public function move(motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            offset.x = offset.x + motion.startX + time * motion.x;
            offset.y = offset.y + motion.startY + time * motion.y;
            offset.z = offset.z + motion.startZ + time * motion.z;
        }

        /**
         * Finds the closest points and the gap (Ericson, "Real-Time Collision Detection", §5.1.9), at s on u and at t on v. The squared distance is smallest
         * where both its derivatives are 0: uu s - uv t + alongU = 0 and uv s - vv t + alongV = 0. After one of s and t is clamped, the other is
         * computed again.
         *
         * @param out receives the vector of the gap, from the closest point of v to the closest point of u
         */
        public function findClosest(out:CoreGap):void
        {
            var uu:Number = u.x * u.x + u.y * u.y + u.z * u.z;
            var vv:Number = v.x * v.x + v.y * v.y + v.z * v.z;
            var uv:Number = u.x * v.x + u.y * v.y + u.z * v.z;
            var alongU:Number = u.x * offset.x + u.y * offset.y + u.z * offset.z;
            var alongV:Number = v.x * offset.x + v.y * offset.y + v.z * offset.z;
            var numerator:Number = uv * alongV - vv * alongU;
            var denominator:Number = uu * vv - uv * uv;
            if (denominator <= Tolerances.NEARLY_PARALLEL * uu * vv)
            {
                // The same values from cross products, which do not cancel.
                var crossX:Number = u.y * v.z - u.z * v.y;
                var crossY:Number = u.z * v.x - u.x * v.z;
                var crossZ:Number = u.x * v.y - u.y * v.x;
                numerator = (v.y * offset.z - v.z * offset.y) * crossX + (v.z * offset.x - v.x * offset.z) * crossY + (v.x * offset.y - v.y * offset.x) * crossZ;
                denominator = crossX * crossX + crossY * crossY + crossZ * crossZ;
            }
            var s:Number = numerator <= 0 ? 0 : (numerator >= denominator ? 1 : numerator / denominator);
            var t:Number = uv * s + alongV;
            if (t <= 0)
            {
                t = 0;
                s = alongU >= 0 ? 0 : (-alongU >= uu ? 1 : -alongU / uu);
            }
            else if (t >= vv)
            {
                t = 1;
                s = uv - alongU;
                s = s <= 0 ? 0 : (s >= uu ? 1 : s / uu);
            }
            else
            {
                t /= vv;
            }
            fractionOfU = s;
            out.x = offset.x + s * u.x - t * v.x;
            out.y = offset.y + s * u.y - t * v.y;
            out.z = offset.z + s * u.z - t * v.z;
        }

        /**
         * Where on u the middle of the closest points is, as <code>findClosest()</code> found them. If the axes are parallel up to rounding, all of the
         * part that they share is equally close, and it is the middle of that part.
         */
        public function get middleOfU():Number
        {
            var crossX:Number = u.y * v.z - u.z * v.y;
            var crossY:Number = u.z * v.x - u.x * v.z;
            var crossZ:Number = u.x * v.y - u.y * v.x;
            var uu:Number = u.x * u.x + u.y * u.y + u.z * u.z;
            var vv:Number = v.x * v.x + v.y * v.y + v.z * v.z;
            if (!(crossX * crossX + crossY * crossY + crossZ * crossZ < Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv))
            {
                return fractionOfU;
            }
            var start:Number = -(u.x * offset.x + u.y * offset.y + u.z * offset.z) / uu;
            var end:Number = start + (u.x * v.x + u.y * v.y + u.z * v.z) / uu;
            return (Math.max(0, Math.min(1, start)) + Math.max(0, Math.min(1, end))) / 2;
        }
    }
}
