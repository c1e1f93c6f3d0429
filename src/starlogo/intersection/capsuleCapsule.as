package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    // The kernel, SegmentSegment, includes the same text. Through it the test takes 2.1 times as long in Adobe's VM, 1.5 in Ruffle, 1.9 in Node.

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
        include "segmentToSegment.inc";
        x += s * ux - t * vx;
        y += s * uy - t * vy;
        z += s * uz - t * vz;
        var reach:Number = (a.radius + b.radius) * Tolerances.TOUCHING;
        return x * x + y * y + z * z <= reach * reach;
    }
}
