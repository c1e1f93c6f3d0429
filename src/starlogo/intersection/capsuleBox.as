package starlogo.intersection
{
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Whether a capsule and a box touch or overlap: compares the distance from the capsule's segment to the box with the radius. Touching
     * counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The test with six axes (thesis §3.6.7) reports false collisions near the box's corners and near the ends of its edges. Here the
     * box's axes only reject capsules that are far away. For the others, the point of the segment that is nearest to the box is found in closed
     * form, and its distance compared.</p>
     *
     * @param capsule in the space of the box; its length may be 0
     * @param box in the space of the capsule; half-extents may be 0
     */
    public function capsuleBox(capsule:Capsule, box:Box):Boolean
    {
        var axis:BoxSegment = BoxSegment.STANDING;
        axis.setTo(capsule, box);
        var radius:Number = capsule.radius * Tolerances.TOUCHING;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        if (axis.x > halfX + radius || axis.x + axis.alongX < -halfX - radius || axis.y > halfY + radius || axis.y + axis.alongY < -halfY - radius
                || axis.z > halfZ + radius || axis.z + axis.alongZ < -halfZ - radius)
        {
            return false;
        }
        axis.findNearest(box);
        // For slabs that the segment is known to be inside of no point is computed, because rounding might put it outside, and a radius of 0 allows no
        // error.
        var share:Number = axis.nearest;
        var x:Number = axis.isInside && axis.alongX > 0 ? 0 : axis.x + share * axis.alongX;
        var y:Number = axis.isInside && axis.alongY > 0 ? 0 : axis.y + share * axis.alongY;
        var z:Number = axis.isInside && axis.alongZ > 0 ? 0 : axis.z + share * axis.alongZ;
        include "squaredToBox.inc";
        return squaredDistance <= radius * radius;
    }
}
