package starlogo.intersection.distance
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.PairTable;

    /**
     * How far two structures are apart, and between which points: 0 if they overlap, and then both points are one that is in both. Exact but for
     * rounding, 1e-15 of their sizes and of the distance; what just touches may be as far apart. Symmetric to the last bit; allocates nothing.
     *
     * @param a a Sphere, Capsule or Box; a radius, length or half-extent may be 0
     * @param b likewise, in the same space
     * @param out takes the distance and the points
     * @throws ArgumentError when there is no test for the pair: cylinders are never collided
     *
     * @private
     */
    public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
    {
        if (a.kind > b.kind)
        {
            PairTable.KERNELS[b.kind << 2 | a.kind].findClosest(b, a, out);
            out.turn();
        }
        else
        {
            PairTable.KERNELS[a.kind << 2 | b.kind].findClosest(a, b, out);
        }
    }
}
