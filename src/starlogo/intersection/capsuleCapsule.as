package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    // This function includes the same text as the kernel CapsuleCapsuleKernel, because a call through the kernel takes about twice as long.

    /**
     * Whether two capsules touch or overlap: compares the distance of their segments with the sum of the radii (thesis §3.6.3). Touching
     * counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The thesis finds the closest points of the two lines and clamps both parameters. That does not always give the closest points of
     * the segments, so here the other parameter is computed again after one is clamped (Ericson, "Real-Time Collision Detection", 5.1.9).
     * Nearly parallel segments cost a little more, because the lines' closest points then come from cross products, which do not
     * cancel.</p>
     *
     * @param a in the space of b; its length may be 0
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function capsuleCapsule(a:Capsule, b:Capsule):Boolean
    {
        var startA:Vector3D = a.start;
        var startB:Vector3D = b.start;
        var aX:Number = startA.x;
        var bX:Number = startB.x;
        // Capsules with the same start touch, so their order does not matter.
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
