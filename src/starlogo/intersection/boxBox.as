package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.boxes.BoxPair;
    import starlogo.intersection.boxes.BoxSeparation;
    import starlogo.intersection.boxes.BoxSweep;

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
        if (centerA.x > centerB.x || centerA.x == centerB.x && compareVectors(centerA, centerB) > 0)
        {
            var first:Box = b;
            b = a;
            a = first;
            centerA = a.center;
            centerB = b.center;
        }
        // This shortens the vector between the centres instead of lengthening six half-extents.
        var touchingFactor:Number = Tolerances.TOUCHING;
        var toX:Number = (centerB.x - centerA.x) / touchingFactor;
        var toY:Number = (centerB.y - centerA.y) / touchingFactor;
        var toZ:Number = (centerB.z - centerA.z) / touchingFactor;
        // the shortened vector, in a's axes
        var axis:Vector3D = a.axisX;
        var x:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
        axis = a.axisY;
        var y:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
        axis = a.axisZ;
        var z:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
        var halfX:Number = a.halfX;
        var halfY:Number = a.halfY;
        var halfZ:Number = a.halfZ;
        var bHalfX:Number = b.halfX;
        var bHalfY:Number = b.halfY;
        var bHalfZ:Number = b.halfZ;
        // the squared distance of b's centre from a, to compare with the two spheres of b
        include "../geometry/squaredToBox.inc";
        if (squaredDistance > bHalfX * bHalfX + bHalfY * bHalfY + bHalfZ * bHalfZ)
        {
            return false;
        }
        var inner:Number = bHalfX < bHalfY ? bHalfX : bHalfY;
        inner = inner < bHalfZ ? inner : bHalfZ;
        if (squaredDistance <= inner * inner)
        {
            return true;
        }
        var pair:BoxPair = BoxPair.SCRATCH;
        pair.offset[0] = x;
        pair.offset[1] = y;
        pair.offset[2] = z;
        pair.setBoxes(a, b);
        if (!BoxSeparation.overlapAlongFacesOfA(pair) || !BoxSeparation.overlapAlongFacesOfB(pair))
        {
            return false;
        }
        if (pair.areNearlyParallel)
        {
            return pair.areZAxesParallel || BoxSweep.areTouching(a, b);
        }
        return BoxSeparation.overlapAcrossEdges(pair);
    }
}
