package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /** The axes of a capsule and another one, or of a sphere and a capsule: that of a sphere is its centre. It finds the gap between the two. Its fields are read only. */
    internal final class SegmentPair
    {
        /** The pair that <code>capsuleCapsule()</code> sets, whose capsules stand. */
        public static const SCRATCH:SegmentPair = new SegmentPair();

        /** The axis of a, and the axis of b, each from its start to its end. */
        public var u:Vector3D = new Vector3D();
        public var v:Vector3D = new Vector3D();

        /** The vector from v's start to u's. */
        public var offset:Vector3D = new Vector3D();

        /** Sets the axes of a and b, each from its start to its end. a is where it is at its motion's time. */
        public function setTo(startA:Vector3D, endA:Vector3D, motion:RelativeMotion, startB:Vector3D, endB:Vector3D):void
        {
            var time:Number = motion.time;
            u.x = endA.x - startA.x;
            u.y = endA.y - startA.y;
            u.z = endA.z - startA.z;
            v.x = endB.x - startB.x;
            v.y = endB.y - startB.y;
            v.z = endB.z - startB.z;
            offset.x = startA.x - startB.x + motion.startX + time * motion.x;
            offset.y = startA.y - startB.y + motion.startY + time * motion.y;
            offset.z = startA.z - startB.z + motion.startZ + time * motion.z;
        }

        /**
         * Finds the gap between the closest points (Ericson, "Real-Time Collision Detection", §5.1.9), at s on u and at t on v. The squared distance is smallest
         * where both its derivatives are 0: uu s - uv t + alongU = 0 and uv s - vv t + alongV = 0. After one of s and t is clamped, the other is
         * computed again.
         *
         * @param out receives the vector of the gap, from the closest point of v to the closest point of u, its squared length, and s as the fraction
         */
        public function findGap(out:RoundGap):void
        {
            var uu:Number = u.x * u.x + u.y * u.y + u.z * u.z;
            var vv:Number = v.x * v.x + v.y * v.y + v.z * v.z;
            var uv:Number = u.x * v.x + u.y * v.y + u.z * v.z;
            var alongU:Number = u.x * offset.x + u.y * offset.y + u.z * offset.z;
            var alongV:Number = v.x * offset.x + v.y * offset.y + v.z * offset.z;
            var numerator:Number = uv * alongV - vv * alongU;
            var denominator:Number = uu * vv - uv * uv;
            if (denominator < Tolerances.NEARLY_PARALLEL * uu * vv)
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
            var gap:CoreGap = out.cores;
            gap.x = offset.x + s * u.x - t * v.x;
            gap.y = offset.y + s * u.y - t * v.y;
            gap.z = offset.z + s * u.z - t * v.z;
            out.squaredLength = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
            out.fraction = s;
        }

        /**
         * Moves the closest point of u to the middle of the part that both axes share, if they are parallel up to rounding. All of that part is equally
         * close.
         *
         * @param gap that of this pair; its fraction changes
         */
        public function moveToMiddle(gap:RoundGap):void
        {
            var crossX:Number = u.y * v.z - u.z * v.y;
            var crossY:Number = u.z * v.x - u.x * v.z;
            var crossZ:Number = u.x * v.y - u.y * v.x;
            var uu:Number = u.x * u.x + u.y * u.y + u.z * u.z;
            var vv:Number = v.x * v.x + v.y * v.y + v.z * v.z;
            if (crossX * crossX + crossY * crossY + crossZ * crossZ < Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv)
            {
                var start:Number = -(u.x * offset.x + u.y * offset.y + u.z * offset.z) / uu;
                var end:Number = start + (u.x * v.x + u.y * v.y + u.z * v.z) / uu;
                gap.fraction = (Math.max(0, Math.min(1, start)) + Math.max(0, Math.min(1, end))) / 2;
            }
        }
    }
}
