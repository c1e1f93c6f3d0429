package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * Whether two structures touch or overlap (thesis §3.6). Symmetric. Allocates nothing. This package has a function for each pair:
     * sphereSphere, sphereCapsule, sphereBox, capsuleCapsule, capsuleBox, boxBox.
     *
     * <p>The costs, relative to sphereSphere, are: sphereCapsule 2, sphereBox 2.5, capsuleCapsule 4, capsuleBox 5 to 7, boxBox 6 to 9.
     * Choosing the function adds 0.5.</p>
     *
     * @param a a Sphere, Capsule or Box
     * @param b a Sphere, Capsule or Box, in the same space
     * @throws ArgumentError if there is no test for the pair, because cylinders are fitted but never collided (thesis §3.6.1)
     * @throws TypeError if a or b is null
     */
    public function intersects(a:BoundingStructure, b:BoundingStructure):Boolean
    {
        switch (3 * a.kind + b.kind)
        {
            case 0:
                return sphereSphere(a as Sphere, b as Sphere);
            case 1:
                return sphereCapsule(a as Sphere, b as Capsule);
            case 2:
                return sphereBox(a as Sphere, b as Box);
            case 3:
                return sphereCapsule(b as Sphere, a as Capsule);
            case 4:
                return capsuleCapsule(a as Capsule, b as Capsule);
            case 5:
                return capsuleBox(a as Capsule, b as Box);
            case 6:
                return sphereBox(b as Sphere, a as Box);
            case 7:
                return capsuleBox(b as Capsule, a as Box);
            case 8:
                return boxBox(a as Box, b as Box);
            default:
                throw new ArgumentError("there is no intersection test for " + a + " and " + b);
        }
    }
}
