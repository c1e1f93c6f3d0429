package starlogo.intersection.sweep
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.PairTable;

    /**
     * Finds when a structure that moves touches one that stands still for the first time: the first moment of the motion, both its ends
     * included, at which <code>intersects()</code> would say that they meet, but for rounding. PairTable has the kernel
     * of each pair. Allocates nothing.
     *
     * <p>Between convex structures the distance along a straight line is a convex function of time. Boxes meet while no axis
     * separates them; spheres and capsules meet when the distance of their cores has come down to the sum of the radii, which is found
     * by Newton's method: from the left it never steps over the first zero of a convex function (van den Bergen, "Ray casting against
     * general convex objects with application to continuous collision detection", 2004).</p>
     *
     * @param a a Sphere, Capsule or Box, which moves
     * @param b likewise, in the same space
     * @param motion of a; takes the time, from 0, which it is when they touch at the beginning, to 1; RelativeMotion.NEVER if they do not touch
     * @throws ArgumentError when there is no test for the pair
     *
     * @private
     */
    public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
    {
        if (a.kind > b.kind)
        {
            var turned:RelativeMotion = RelativeMotion.turned(motion);
            PairTable.KERNELS[b.kind << 2 | a.kind].findTime(b, a, turned);
            motion.time = turned.time;
            return;
        }
        PairTable.KERNELS[a.kind << 2 | b.kind].findTime(a, b, motion);
    }
}
