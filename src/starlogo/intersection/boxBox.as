package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;

    // BoxSweep tries the same axes, and a motion of no length gives the same answer. This function has arithmetic of its own, because the
    // sweep is slower. KernelsAgreeTest checks that both agree.

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
        var toX:Number = centerB.x - centerA.x;
        // Boxes with the same centre touch, so their order does not matter.
        if (toX < 0 || (toX == 0 && isAfter(centerA, centerB)))
        {
            var first:Box = b;
            b = a;
            a = first;
            centerA = a.center;
            centerB = b.center;
            toX = -toX;
        }
        var touching:Number = Tolerances.TOUCHING;
        toX /= touching;
        var toY:Number = (centerB.y - centerA.y) / touching;
        var toZ:Number = (centerB.z - centerA.z) / touching;

        // The vector between the centres, in a's axes.
        var axis:Vector3D;
        axis = a.axisX;
        var aXx:Number = axis.x;
        var aXy:Number = axis.y;
        var aXz:Number = axis.z;
        var x:Number = toX * aXx + toY * aXy + toZ * aXz;
        axis = a.axisY;
        var aYx:Number = axis.x;
        var aYy:Number = axis.y;
        var aYz:Number = axis.z;
        var y:Number = toX * aYx + toY * aYy + toZ * aYz;
        axis = a.axisZ;
        var aZx:Number = axis.x;
        var aZy:Number = axis.y;
        var aZz:Number = axis.z;
        var z:Number = toX * aZx + toY * aZy + toZ * aZz;
        var halfX:Number = a.halfX;
        var halfY:Number = a.halfY;
        var halfZ:Number = a.halfZ;
        var bX:Number = b.halfX;
        var bY:Number = b.halfY;
        var bZ:Number = b.halfZ;

        // The squared distance of b's centre from a, to compare with the two spheres of b.
        include "squaredToBox.inc";
        if (squaredDistance > bX * bX + bY * bY + bZ * bZ)
        {
            return false;
        }
        var inner:Number = bX < bY ? bX : bY;
        inner = inner < bZ ? inner : bZ;
        if (squaredDistance <= inner * inner)
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
        var radius:Number;
        var m00:Number = aXx * bXx + aXy * bXy + aXz * bXz;
        var abs00:Number = m00 < 0 ? -m00 : m00;
        var m01:Number = aXx * bYx + aXy * bYy + aXz * bYz;
        var abs01:Number = m01 < 0 ? -m01 : m01;
        var m02:Number = aXx * bZx + aXy * bZy + aXz * bZz;
        var abs02:Number = m02 < 0 ? -m02 : m02;
        radius = halfX + bX * abs00 + bY * abs01 + bZ * abs02;
        if (x > radius || x < -radius)
        {
            return false;
        }
        var m10:Number = aYx * bXx + aYy * bXy + aYz * bXz;
        var abs10:Number = m10 < 0 ? -m10 : m10;
        var m11:Number = aYx * bYx + aYy * bYy + aYz * bYz;
        var abs11:Number = m11 < 0 ? -m11 : m11;
        var m12:Number = aYx * bZx + aYy * bZy + aYz * bZz;
        var abs12:Number = m12 < 0 ? -m12 : m12;
        radius = halfY + bX * abs10 + bY * abs11 + bZ * abs12;
        if (y > radius || y < -radius)
        {
            return false;
        }
        var m20:Number = aZx * bXx + aZy * bXy + aZz * bXz;
        var abs20:Number = m20 < 0 ? -m20 : m20;
        var m21:Number = aZx * bYx + aZy * bYy + aZz * bYz;
        var abs21:Number = m21 < 0 ? -m21 : m21;
        var m22:Number = aZx * bZx + aZy * bZy + aZz * bZz;
        var abs22:Number = m22 < 0 ? -m22 : m22;
        radius = halfZ + bX * abs20 + bY * abs21 + bZ * abs22;
        if (z > radius || z < -radius)
        {
            return false;
        }

        // The faces of b.
        var along:Number = toX * bXx + toY * bXy + toZ * bXz;
        radius = bX + halfX * abs00 + halfY * abs10 + halfZ * abs20;
        if (along > radius || along < -radius)
        {
            return false;
        }
        along = toX * bYx + toY * bYy + toZ * bYz;
        radius = bY + halfX * abs01 + halfY * abs11 + halfZ * abs21;
        if (along > radius || along < -radius)
        {
            return false;
        }
        along = toX * bZx + toY * bZy + toZ * bZz;
        radius = bZ + halfX * abs02 + halfY * abs12 + halfZ * abs22;
        if (along > radius || along < -radius)
        {
            return false;
        }

        // The cross products of edges. If two edges are nearly parallel, these products would cancel.
        var near:Number = 1 - Tolerances.NEARLY_PARALLEL / 2;
        if (abs22 > near || abs21 > near || abs20 > near
                || abs12 > near || abs11 > near || abs10 > near
                || abs02 > near || abs01 > near || abs00 > near)
        {
            // their z axes are parallel
            if (m02 * m02 + m12 * m12 <= Tolerances.PARALLEL)
            {
                return true;
            }
            // The sweep's axes do not cancel.
            return PairTable.kernelOf(a, b).areTouching(a, b);
        }
        var overlap:Boolean;
        include "boxEdges.inc";
        return overlap;
    }
}
