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
        for (var i:int = 0; i < 3; i++)
        {
            var reach:Number = segment.halves[i] + radius;
            var start:Number = segment.start[i];
            var end:Number = start + segment.along[i];
            if (start > reach && end > reach || start < -reach && end < -reach)
            {
                return false;
            }
        }
        var gap:RoundGap = RoundGap.SCRATCH;
        segment.findClosest(gap);
        var x:Number = gap.place.x;
        var y:Number = gap.place.y;
        var z:Number = gap.place.z;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        include "../geometry/squaredToBox.inc";
        return squaredDistance <= radius * radius;
    }
}
