package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.BoxSweep;

    // BoxSweep tries the same axes, and a motion of no length gives the same answer. This function has arithmetic of its own, because the
    // sweep is slower. KernelsAgreeTest checks that both agree.

    /**
     * Whether two boxes touch or overlap, by separating axes (thesis §3.6.4; Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996;
     * Ericson, "Real-Time Collision Detection", §4.4.1). Touching counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>Two spheres decide most pairs before any axis is tried: the smallest sphere around b and the largest sphere inside of b. Then come the
     * faces of both and the cross products of their edges. If the z axes of both boxes are parallel, the faces are enough. If other axes are, or
     * are nearly so, the sweep decides, whose edge axes do not cancel.</p>
     *
     * @param a in the space of b; half-extents may be 0
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function boxBox(a:Box, b:Box):Boolean
    {
        var centerA:Vector3D = a.center;
        var centerB:Vector3D = b.center;
        // For most boxes x alone decides about the order, without a call. Boxes with the same centre touch, so their order does not matter.
        if (centerA.x > centerB.x || centerA.x == centerB.x && isAfter(centerA, centerB))
        {
            var first:Box = b;
            b = a;
            a = first;
            centerA = a.center;
            centerB = b.center;
        }
        var touchingFactor:Number = Tolerances.TOUCHING;
        var toX:Number = (centerB.x - centerA.x) / touchingFactor;
        var toY:Number = (centerB.y - centerA.y) / touchingFactor;
        var toZ:Number = (centerB.z - centerA.z) / touchingFactor;

        // The vector between the centres, in a's axes.
        var axis:Vector3D = a.axisX;
        var x:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
        axis = a.axisY;
        var y:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
        axis = a.axisZ;
        var z:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
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

        // The axes of b.
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

        // The cosines of the angles between the axes, and their absolute values.
        axis = a.axisX;
        var m00:Number = axis.x * bXx + axis.y * bXy + axis.z * bXz;
        var m01:Number = axis.x * bYx + axis.y * bYy + axis.z * bYz;
        var m02:Number = axis.x * bZx + axis.y * bZy + axis.z * bZz;
        axis = a.axisY;
        var m10:Number = axis.x * bXx + axis.y * bXy + axis.z * bXz;
        var m11:Number = axis.x * bYx + axis.y * bYy + axis.z * bYz;
        var m12:Number = axis.x * bZx + axis.y * bZy + axis.z * bZz;
        axis = a.axisZ;
        var m20:Number = axis.x * bXx + axis.y * bXy + axis.z * bXz;
        var m21:Number = axis.x * bYx + axis.y * bYy + axis.z * bYz;
        var m22:Number = axis.x * bZx + axis.y * bZy + axis.z * bZz;
        var abs00:Number = m00 < 0 ? -m00 : m00;
        var abs01:Number = m01 < 0 ? -m01 : m01;
        var abs02:Number = m02 < 0 ? -m02 : m02;
        var abs10:Number = m10 < 0 ? -m10 : m10;
        var abs11:Number = m11 < 0 ? -m11 : m11;
        var abs12:Number = m12 < 0 ? -m12 : m12;
        var abs20:Number = m20 < 0 ? -m20 : m20;
        var abs21:Number = m21 < 0 ? -m21 : m21;
        var abs22:Number = m22 < 0 ? -m22 : m22;
        var overlap:Boolean;
        var along:Number;
        var radius:Number;
        // The faces of a, then those of b.
        radius = halfX + bX * abs00 + bY * abs01 + bZ * abs02;
        overlap = x <= radius && x >= -radius;
        radius = halfY + bX * abs10 + bY * abs11 + bZ * abs12;
        overlap = overlap && y <= radius && y >= -radius;
        radius = halfZ + bX * abs20 + bY * abs21 + bZ * abs22;
        overlap = overlap && z <= radius && z >= -radius;
        along = toX * bXx + toY * bXy + toZ * bXz;
        radius = bX + halfX * abs00 + halfY * abs10 + halfZ * abs20;
        overlap = overlap && along <= radius && along >= -radius;
        along = toX * bYx + toY * bYy + toZ * bYz;
        radius = bY + halfX * abs01 + halfY * abs11 + halfZ * abs21;
        overlap = overlap && along <= radius && along >= -radius;
        along = toX * bZx + toY * bZy + toZ * bZz;
        radius = bZ + halfX * abs02 + halfY * abs12 + halfZ * abs22;
        overlap = overlap && along <= radius && along >= -radius;
        if (!overlap)
        {
            return false;
        }

        // If two edges are nearly parallel, their cross product would cancel.
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
            return BoxSweep.areTouching(a, b);
        }
        include "boxEdges.inc";
        return overlap;
    }
}
