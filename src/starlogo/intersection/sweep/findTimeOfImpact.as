package starlogo.intersection.sweep
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.PairTable;

    /**
     * Finds when a moving structure first touches one that stands still: the first moment at which <code>intersects()</code> would return
     * true, except for rounding. The motion's start and end are included. PairTable has the kernel of each pair. Allocates nothing.
     *
     * <p>The distance of two convex structures is a convex function of time if one moves along a straight line. Boxes touch while no axis
     * separates them. Spheres and capsules touch once the distance of their cores is the sum of the radii. Newton's method finds that time,
     * because from the left it never steps over the first zero of a convex function (van den Bergen, "Ray casting against general convex
     * objects with application to continuous collision detection", 2004).</p>
     *
     * @param a a Sphere, Capsule or Box, which moves
     * @param b a Sphere, Capsule or Box, in the same space
     * @param motion the motion of a; receives the time: 0 if they touch at the beginning, at most 1, or RelativeMotion.NEVER if they do not
     *     touch
     * @private
     */
    public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
    {
        if (a.kind > b.kind)
        {
            var reversed:RelativeMotion = PairTable.REVERSED;
            reversed.setReversed(motion);
            PairTable.KERNELS[3 * b.kind + a.kind].findTime(b, a, reversed);
            motion.time = reversed.time;
            return;
        }
        PairTable.KERNELS[3 * a.kind + b.kind].findTime(a, b, motion);
    }
}
