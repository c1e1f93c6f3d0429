package starlogo.intersection.sweep
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * When a structure that moves touches one that stands still for the first time: the first moment of the way, both its ends
     * included, at which <code>intersects()</code> would say that they meet, but for rounding. The test of a pair is the function of
     * that name in this package. Allocates nothing.
     *
     * <p>Between convex structures the distance along a straight way is a convex function of time. Boxes meet while no axis
     * separates them; spheres and capsules meet when the distance of their cores has come down to the sum of the radii, which is found
     * by Newton's method: from the left it never steps over the first zero of a convex function (van den Bergen, "Ray casting against
     * general convex objects with application to continuous collision detection", 2004).</p>
     *
     * @param a a Sphere, Capsule or Box, which moves
     * @param b likewise, in the same space
     * @param way of a
     * @return from 0, which it is when they touch at the beginning, to 1; RelativeMotion.NEVER if they do not touch
     * @throws ArgumentError when there is no test for the pair
     *
     * @private
     */
    public function timeOfImpact(a:BoundingStructure, b:BoundingStructure, way:RelativeMotion):Number
    {
        switch (a.kind << 2 | b.kind)
        {
            case 0:
                return sphereSphereImpact(a as Sphere, b as Sphere, way);
            case 1:
                return sphereCapsuleImpact(a as Sphere, b as Capsule, way);
            case 2:
                return sphereBoxImpact(a as Sphere, b as Box, way);
            case 4:
                return sphereCapsuleImpact(b as Sphere, a as Capsule, RelativeMotion.turned(way));
            case 5:
                return capsuleCapsuleImpact(a as Capsule, b as Capsule, way);
            case 6:
                return capsuleBoxImpact(a as Capsule, b as Box, way);
            case 8:
                return sphereBoxImpact(b as Sphere, a as Box, RelativeMotion.turned(way));
            case 9:
                return capsuleBoxImpact(b as Capsule, a as Box, RelativeMotion.turned(way));
            case 10:
                return boxBoxImpact(a as Box, b as Box, way);
            default:
                throw new ArgumentError("there is no test of motion for " + a + " and " + b);
        }
    }
}
