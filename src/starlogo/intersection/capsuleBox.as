package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    // This function repeats the arithmetic of the kernel CapsuleBoxKernel, because a call through the kernel is slower.
    // KernelsAgreeTest checks that both agree.

    /**
     * Whether a capsule and a box touch or overlap: compares the distance from the capsule's segment to the box with the radius. Touching
     * counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The test with six axes (thesis §3.6.7) reports false collisions near the box's corners and near the ends of its edges. Here the
     * box's axes only reject capsules that are far away. The squared distance to the box is convex along the segment, and quadratic between
     * the points where the segment crosses the planes of the box's faces. So its minimum has a closed form.</p>
     *
     * <p>The steps are: transform the segment into the box's axes, and reject it if it is far away; find where its line enters and leaves
     * the slabs; find the point of it that is nearest to the box; compare that point's distance.</p>
     *
     * @param capsule in the space of the box; its length may be 0
     * @param box in the space of the capsule; half-extents may be 0
     */
    public function capsuleBox(capsule:Capsule, box:Box):Boolean
    {
        var radius:Number = capsule.radius * Tolerances.TOUCHING;
        var center:Vector3D = box.center;
        var start:Vector3D = capsule.start;
        var end:Vector3D = capsule.end;
        var startX:Number = start.x;
        var startY:Number = start.y;
        var startZ:Number = start.z;
        var x:Number = end.x - startX;
        var y:Number = end.y - startY;
        var z:Number = end.z - startZ;
        startX -= center.x;
        startY -= center.y;
        startZ -= center.z;

        // The segment in the box's axes is p + t * d. It is mirrored so that no component of d is negative.
        var axis:Vector3D = box.axisX;
        var axisX:Number = axis.x;
        var axisY:Number = axis.y;
        var axisZ:Number = axis.z;
        var px:Number = axisX * startX + axisY * startY + axisZ * startZ;
        var dx:Number = axisX * x + axisY * y + axisZ * z;
        var halfX:Number = box.halfX;
        if (dx < 0)
        {
            dx = -dx;
            px = -px;
        }
        var reach:Number = halfX + radius;
        if (px > reach || px + dx < -reach)
        {
            return false;
        }
        axis = box.axisY;
        axisX = axis.x;
        axisY = axis.y;
        axisZ = axis.z;
        var py:Number = axisX * startX + axisY * startY + axisZ * startZ;
        var dy:Number = axisX * x + axisY * y + axisZ * z;
        var halfY:Number = box.halfY;
        if (dy < 0)
        {
            dy = -dy;
            py = -py;
        }
        reach = halfY + radius;
        if (py > reach || py + dy < -reach)
        {
            return false;
        }
        axis = box.axisZ;
        axisX = axis.x;
        axisY = axis.y;
        axisZ = axis.z;
        var pz:Number = axisX * startX + axisY * startY + axisZ * startZ;
        var dz:Number = axisX * x + axisY * y + axisZ * z;
        var halfZ:Number = box.halfZ;
        if (dz < 0)
        {
            dz = -dz;
            pz = -pz;
        }
        reach = halfZ + radius;
        if (pz > reach || pz + dz < -reach)
        {
            return false;
        }

        include "segmentToBox.inc";

        // This also catches NaN, because the products of tiny numbers may be 0.
        if (!(t > 0))
        {
            t = 0;
        }
        else if (t > 1)
        {
            t = 1;
        }

        // The segment is not outside if a part of it is inside of all slabs that it crosses. Then only slabs parallel to it are tested. For
        // the others no point is computed, because rounding might put it outside, and a radius of 0 allows no error.
        var isOutside:Boolean = lastIn > firstOut || lastIn > 1 || firstOut < 0;
        if (!isOutside && dx > 0 && dy > 0 && dz > 0)
        {
            return true;
        }
        x = isOutside || dx == 0 ? px + t * dx : 0;
        y = isOutside || dy == 0 ? py + t * dy : 0;
        z = isOutside || dz == 0 ? pz + t * dz : 0;
        include "squaredToBox.inc";
        return gapSquared <= radius * radius;
    }
}
