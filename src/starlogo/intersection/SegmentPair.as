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

        /** u is the axis of a, and v the axis of b, each from its start to its end. All fields are read only. */
        public var uX:Number = 0;
        public var uY:Number = 0;
        public var uZ:Number = 0;
        public var vX:Number = 0;
        public var vY:Number = 0;
        public var vZ:Number = 0;

        /** The vector from v's start to u's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Where u's closest point is: from 0 at its start to 1 at its end. <code>findClosest()</code> finds it. */
        public var fractionOfU:Number = 0;

        /** Sets the axes: that of a from its start to its end, and that of a capsule. */
        public function setTo(startA:Vector3D, endA:Vector3D, b:Capsule):void
        {
            var startB:Vector3D = b.start;
            var endB:Vector3D = b.end;
            uX = endA.x - startA.x;
            uY = endA.y - startA.y;
            uZ = endA.z - startA.z;
            vX = endB.x - startB.x;
            vY = endB.y - startB.y;
            vZ = endB.z - startB.z;
            x = startA.x - startB.x;
            y = startA.y - startB.y;
            z = startA.z - startB.z;
        }

        /** Moves u to where a is at its motion's time. */
        public function move(motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            x = x + motion.startX + time * motion.x;
            y = y + motion.startY + time * motion.y;
            z = z + motion.startZ + time * motion.z;
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
            var uu:Number = uX * uX + uY * uY + uZ * uZ;
            var vv:Number = vX * vX + vY * vY + vZ * vZ;
            var uv:Number = uX * vX + uY * vY + uZ * vZ;
            var alongU:Number = uX * x + uY * y + uZ * z;
            var alongV:Number = vX * x + vY * y + vZ * z;
            var numerator:Number = uv * alongV - vv * alongU;
            var denominator:Number = uu * vv - uv * uv;
            if (denominator <= Tolerances.NEARLY_PARALLEL * uu * vv)
            {
                // The same values from cross products, which do not cancel.
                var crossX:Number = uY * vZ - uZ * vY;
                var crossY:Number = uZ * vX - uX * vZ;
                var crossZ:Number = uX * vY - uY * vX;
                numerator = (vY * z - vZ * y) * crossX + (vZ * x - vX * z) * crossY + (vX * y - vY * x) * crossZ;
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
            out.x = x + s * uX - t * vX;
            out.y = y + s * uY - t * vY;
            out.z = z + s * uZ - t * vZ;
        }

        /**
         * Where on u the middle of the closest points is, as <code>findClosest()</code> found them. If the axes are parallel up to rounding, all of the
         * part that they share is equally close, and it is the middle of that part.
         */
        public function get middleOfU():Number
        {
            var crossX:Number = uY * vZ - uZ * vY;
            var crossY:Number = uZ * vX - uX * vZ;
            var crossZ:Number = uX * vY - uY * vX;
            var uu:Number = uX * uX + uY * uY + uZ * uZ;
            var vv:Number = vX * vX + vY * vY + vZ * vZ;
            if (!(crossX * crossX + crossY * crossY + crossZ * crossZ < Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv))
            {
                return fractionOfU;
            }
            var start:Number = -(uX * x + uY * y + uZ * z) / uu;
            var end:Number = start + (uX * vX + uY * vY + uZ * vZ) / uu;
            return (Math.max(0, Math.min(1, start)) + Math.max(0, Math.min(1, end))) / 2;
        }
    }
}
