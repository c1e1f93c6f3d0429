package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    // Written out: through the kernel, SegmentSegment, it takes 2.1 times as long in Adobe's VM, 1.5 in Ruffle, 1.9 in Node; KernelsAgreeTest has both agree.

    /**
     * Whether two capsules meet: the distance of their segments against the sum of the radii (thesis §3.6.3).
     *
     * <p>Clamping both parameters of the closest points of the two lines, as the thesis does, does not give the closest
     * points of the segments: once one is clamped, the other has to be computed again (Ericson, "Real-Time Collision
     * Detection", 5.1.9). Nearly parallel segments cost a little more: the lines' closest points then come from
     * cross products, which do not cancel. Touching counts, to within Tolerances.TOUCHING. Allocates nothing.</p>
     *
     * @param a in the space of b; it may have no length
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function capsuleCapsule(a:Capsule, b:Capsule):Boolean
    {
        var startA:Vector3D = a.start;
        var startB:Vector3D = b.start;
        var aX:Number = startA.x;
        var bX:Number = startB.x;
        // Capsules that share their start meet, in either order.
        if (aX > bX || (aX == bX && isAfter(startA, startB)))
        {
            var first:Capsule = b;
            b = a;
            a = first;
            startA = a.start;
            startB = b.start;
            aX = startA.x;
            bX = startB.x;
        }
        var aY:Number = startA.y;
        var aZ:Number = startA.z;
        var bY:Number = startB.y;
        var bZ:Number = startB.z;
        var end:Vector3D = a.end;
        var ux:Number = end.x - aX;
        var uy:Number = end.y - aY;
        var uz:Number = end.z - aZ;
        end = b.end;
        var vx:Number = end.x - bX;
        var vy:Number = end.y - bY;
        var vz:Number = end.z - bZ;
        var x:Number = aX - bX;
        var y:Number = aY - bY;
        var z:Number = aZ - bZ;

        // The squared distance of a.start + s * u from b.start + t * v is least where both its derivatives vanish:
        // uu * s - uv * t + alongU = 0 and uv * s - vv * t + alongV = 0.
        var uu:Number = ux * ux + uy * uy + uz * uz;
        var vv:Number = vx * vx + vy * vy + vz * vz;
        var uv:Number = ux * vx + uy * vy + uz * vz;
        var alongU:Number = ux * x + uy * y + uz * z;
        var alongV:Number = vx * x + vy * y + vz * z;
        var numerator:Number = uv * alongV - vv * alongU;
        var denominator:Number = uu * vv - uv * uv;
        if (denominator <= Tolerances.NEARLY_PARALLEL * uu * vv)
        {
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            numerator = (vy * z - vz * y) * crossX + (vz * x - vx * z) * crossY + (vx * y - vy * x) * crossZ;
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
        x += s * ux - t * vx;
        y += s * uy - t * vy;
        z += s * uz - t * vz;
        var reach:Number = (a.radius + b.radius) * Tolerances.TOUCHING;
        return x * x + y * y + z * z <= reach * reach;
    }
}
