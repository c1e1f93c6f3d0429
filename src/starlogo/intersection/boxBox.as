package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findBoxImpact;

    // This function repeats the arithmetic of the kernel BoxPair, because a call through the kernel takes about three times as long.
    // KernelsAgreeTest checks that both agree.

    /**
     * Whether two boxes touch or overlap, by separating axes (thesis §3.6.4; Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996;
     * Ericson, "Real-Time Collision Detection", §4.4.1). Touching counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>Two spheres decide most pairs before any axis is tried: the smallest sphere around b and the largest sphere inside of b. If an
     * edge of one box is parallel to an edge of the other, the six face axes are enough. If it is nearly parallel, the edge axes are
     * computed so that no rounding error separates boxes that touch.</p>
     *
     * <p>The steps are: the vector between the centres, in a's axes; the two spheres of b; the faces of a, then of b; the cross products of
     * edges, a's axisX with each of b's first.</p>
     *
     * @param a in the space of b; half-extents may be 0
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function boxBox(a:Box, b:Box):Boolean
    {
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        var x:Number = centerB.x - centerA.x;
        // Boxes with the same centre touch, so their order does not matter.
        if (x < 0 || (x == 0 && isAfter(centerA, centerB)))
        {
            var first:Box = b;
            b = a;
            a = first;
            centerA = a.center;
            centerB = b.center;
            x = -x;
        }
        var touching:Number = Tolerances.TOUCHING;
        x /= touching;
        var y:Number = (centerB.y - centerA.y) / touching;
        var z:Number = (centerB.z - centerA.z) / touching;

        // The vector between the centres, in a's axes.
        var axis:Vector3D;
        axis = a.axisX;
        var aXx:Number = axis.x;
        var aXy:Number = axis.y;
        var aXz:Number = axis.z;
        var tX:Number = x * aXx + y * aXy + z * aXz;
        axis = a.axisY;
        var aYx:Number = axis.x;
        var aYy:Number = axis.y;
        var aYz:Number = axis.z;
        var tY:Number = x * aYx + y * aYy + z * aYz;
        axis = a.axisZ;
        var aZx:Number = axis.x;
        var aZy:Number = axis.y;
        var aZz:Number = axis.z;
        var tZ:Number = x * aZx + y * aZy + z * aZz;
        var halfAX:Number = a.halfX;
        var halfAY:Number = a.halfY;
        var halfAZ:Number = a.halfZ;
        var halfBX:Number = b.halfX;
        var halfBY:Number = b.halfY;
        var halfBZ:Number = b.halfZ;

        // The squared distance of b's centre from a, to compare with the two spheres of b.
        var gapSquared:Number = 0;
        var gap:Number = tX < 0 ? -tX : tX;
        gap -= halfAX;
        if (gap > 0)
        {
            gapSquared += gap * gap;
        }
        gap = tY < 0 ? -tY : tY;
        gap -= halfAY;
        if (gap > 0)
        {
            gapSquared += gap * gap;
        }
        gap = tZ < 0 ? -tZ : tZ;
        gap -= halfAZ;
        if (gap > 0)
        {
            gapSquared += gap * gap;
        }
        if (gapSquared > halfBX * halfBX + halfBY * halfBY + halfBZ * halfBZ)
        {
            return false;
        }
        var inner:Number = halfBX < halfBY ? halfBX : halfBY;
        inner = inner < halfBZ ? inner : halfBZ;
        if (gapSquared <= inner * inner)
        {
            return true;
        }

        axis = b.axisX;
        var bXx:Number = axis.x;
        var bXy:Number = axis.y;
        var bXz:Number = axis.z;
        axis = b.axisY;
        var bYx:Number = axis.x;
        var bYy:Number = axis.y;
        var bYz:Number = axis.z;
        axis = b.axisZ;
        var bZx:Number = axis.x;
        var bZy:Number = axis.y;
        var bZz:Number = axis.z;

        // The faces of a. The cosines of the angles between the axes, and their absolute values.
        var reach:Number;
        var cosXX:Number = aXx * bXx + aXy * bXy + aXz * bXz;
        var absXX:Number = cosXX < 0 ? -cosXX : cosXX;
        var cosXY:Number = aXx * bYx + aXy * bYy + aXz * bYz;
        var absXY:Number = cosXY < 0 ? -cosXY : cosXY;
        var cosXZ:Number = aXx * bZx + aXy * bZy + aXz * bZz;
        var absXZ:Number = cosXZ < 0 ? -cosXZ : cosXZ;
        reach = halfAX + halfBX * absXX + halfBY * absXY + halfBZ * absXZ;
        if (tX > reach || tX < -reach)
        {
            return false;
        }
        var cosYX:Number = aYx * bXx + aYy * bXy + aYz * bXz;
        var absYX:Number = cosYX < 0 ? -cosYX : cosYX;
        var cosYY:Number = aYx * bYx + aYy * bYy + aYz * bYz;
        var absYY:Number = cosYY < 0 ? -cosYY : cosYY;
        var cosYZ:Number = aYx * bZx + aYy * bZy + aYz * bZz;
        var absYZ:Number = cosYZ < 0 ? -cosYZ : cosYZ;
        reach = halfAY + halfBX * absYX + halfBY * absYY + halfBZ * absYZ;
        if (tY > reach || tY < -reach)
        {
            return false;
        }
        var cosZX:Number = aZx * bXx + aZy * bXy + aZz * bXz;
        var absZX:Number = cosZX < 0 ? -cosZX : cosZX;
        var cosZY:Number = aZx * bYx + aZy * bYy + aZz * bYz;
        var absZY:Number = cosZY < 0 ? -cosZY : cosZY;
        var cosZZ:Number = aZx * bZx + aZy * bZy + aZz * bZz;
        var absZZ:Number = cosZZ < 0 ? -cosZZ : cosZZ;
        reach = halfAZ + halfBX * absZX + halfBY * absZY + halfBZ * absZZ;
        if (tZ > reach || tZ < -reach)
        {
            return false;
        }

        // The faces of b.
        var along:Number = x * bXx + y * bXy + z * bXz;
        reach = halfBX + halfAX * absXX + halfAY * absYX + halfAZ * absZX;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = x * bYx + y * bYy + z * bYz;
        reach = halfBY + halfAX * absXY + halfAY * absYY + halfAZ * absZY;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = x * bZx + y * bZy + z * bZz;
        reach = halfBZ + halfAX * absXZ + halfAY * absYZ + halfAZ * absZZ;
        if (along > reach || along < -reach)
        {
            return false;
        }

        // The cross products of edges. If two edges are nearly parallel, these products would cancel.
        var near:Number = 1 - Tolerances.NEARLY_PARALLEL / 2;
        if (absZZ > near || absZY > near || absZX > near
                || absYZ > near || absYY > near || absYX > near
                || absXZ > near || absXY > near || absXX > near)
        {
            // Both boxes are upright.
            if (cosXZ * cosXZ + cosYZ * cosYZ <= Tolerances.PARALLEL)
            {
                return true;
            }
            // The sweep's axes do not cancel.
            var standing:RelativeMotion = RelativeMotion.turned(RelativeMotion.NONE);
            findBoxImpact(a, b, standing);
            return standing.time == 0;
        }
        along = tZ * cosYX - tY * cosZX;
        reach = halfAY * absZX + halfAZ * absYX + halfBY * absXZ + halfBZ * absXY;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tZ * cosYY - tY * cosZY;
        reach = halfAY * absZY + halfAZ * absYY + halfBZ * absXX + halfBX * absXZ;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tZ * cosYZ - tY * cosZZ;
        reach = halfAY * absZZ + halfAZ * absYZ + halfBX * absXY + halfBY * absXX;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tX * cosZX - tZ * cosXX;
        reach = halfAZ * absXX + halfAX * absZX + halfBY * absYZ + halfBZ * absYY;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tX * cosZY - tZ * cosXY;
        reach = halfAZ * absXY + halfAX * absZY + halfBZ * absYX + halfBX * absYZ;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tX * cosZZ - tZ * cosXZ;
        reach = halfAZ * absXZ + halfAX * absZZ + halfBX * absYY + halfBY * absYX;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tY * cosXX - tX * cosYX;
        reach = halfAX * absYX + halfAY * absXX + halfBY * absZZ + halfBZ * absZY;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tY * cosXY - tX * cosYY;
        reach = halfAX * absYY + halfAY * absXY + halfBZ * absZX + halfBX * absZZ;
        if (along > reach || along < -reach)
        {
            return false;
        }
        along = tY * cosXZ - tX * cosYZ;
        reach = halfAX * absYZ + halfAY * absXZ + halfBX * absZY + halfBY * absZX;
        if (along > reach || along < -reach)
        {
            return false;
        }
        return true;
    }
}
