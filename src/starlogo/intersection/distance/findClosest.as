package starlogo.intersection.distance
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.intersection.PairTable;

    /**
     * Finds the distance of two structures and their closest points. If the structures overlap, the distance is 0, and both points are one
     * point inside of both.
     *
     * <p>The result is exact except for rounding, which is 1e-15 of their sizes and of the distance. So structures that just touch may have
     * a distance as small as that. Symmetric to the last bit. Allocates nothing.</p>
     *
     * @param a a Sphere, Capsule, Box or Hull; a radius, length or half-extent may be 0
     * @param b a Sphere, Capsule, Box or Hull, in the same space
     * @param out receives the distance and the points
     * @throws ArgumentError if there is no such test for the pair
     * @private
     */
    public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
    {
        PairTable.kernelOf(a, b).findClosest(a, b, out);
    }
}
