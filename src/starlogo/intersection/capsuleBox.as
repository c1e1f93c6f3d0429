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
        var segment:BoxSegment = BoxSegment.SCRATCH;
        segment.setTo(capsule, box);
        var radius:Number = capsule.radius * Tolerances.TOUCHING;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        var endX:Number = segment.start.x + segment.along.x;
        var endY:Number = segment.start.y + segment.along.y;
        var endZ:Number = segment.start.z + segment.along.z;
        if (segment.start.x > halfX + radius && endX > halfX + radius || segment.start.x < -halfX - radius && endX < -halfX - radius
                || segment.start.y > halfY + radius && endY > halfY + radius || segment.start.y < -halfY - radius && endY < -halfY - radius
                || segment.start.z > halfZ + radius && endZ > halfZ + radius || segment.start.z < -halfZ - radius && endZ < -halfZ - radius)
        {
            return false;
        }
        segment.findClosest(box);
        // For slabs that the segment is known to be inside of no point is computed, because rounding might put it outside, and a radius of 0 allows no
        // error.
        var fraction:Number = segment.fraction;
        var x:Number = segment.isInside && segment.along.x != 0 ? 0 : segment.start.x + fraction * segment.along.x;
        var y:Number = segment.isInside && segment.along.y != 0 ? 0 : segment.start.y + fraction * segment.along.y;
        var z:Number = segment.isInside && segment.along.z != 0 ? 0 : segment.start.z + fraction * segment.along.z;
        include "../geometry/squaredToBox.inc";
        return squaredDistance <= radius * radius;
    }
}
