package starlogo.intersection.sweep
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.PairTable;

    /**
     * Finds when a moving structure first touches one that stands still: the first moment at which <code>intersects()</code> would return
     * true, except for rounding. The motion's start and end are included. PairTable has the kernel of each pair. Allocates nothing.
     *
     * <p>Boxes touch while no axis separates them. Two spheres touch first at the smaller root of a quadratic equation. The pairs with a capsule, and a
     * sphere and a box, touch once the distance of their cores is the sum of the radii. This distance is a convex function of time if one moves along
     * a straight line. So Newton's method finds the time, because from the left it never steps over the first zero (van den Bergen, "Ray casting
     * against general convex objects with application to continuous collision detection", 2004).</p>
     *
     * @param a a Sphere, Capsule, Box or Hull, which moves
     * @param b a Sphere, Capsule, Box or Hull, in the same space
     * @param motion the motion of a; receives the time: 0 if they touch at the beginning, at most 1, or RelativeMotion.NEVER if they do not
     *     touch
     * @throws ArgumentError if there is no such test for the pair
     * @private
     */
    public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
    {
        PairTable.kernelOf(a, b).findTime(a, b, motion);
    }
}
