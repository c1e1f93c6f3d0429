package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;

    /**
     * Whether two structures touch or overlap (thesis §3.6). Symmetric. For each pair of spheres, capsules and boxes this package also has a function
     * with the same answer. From the fastest to the slowest, these are: sphereSphere, sphereCapsule, sphereBox, capsuleCapsule, capsuleBox,
     * boxBox. They allocate nothing. A test with a hull finds the distance of two convex shapes.
     *
     * @param a a Sphere, Capsule, Box or Hull
     * @param b a Sphere, Capsule, Box or Hull, in the same space
     * @throws ArgumentError if there is no test for the pair, because cylinders are fitted but never collided (thesis §3.6.1). If a or b is null,
     *     it throws an error too
     */
    public function intersects(a:BoundingStructure, b:BoundingStructure):Boolean
    {
        return StructurePairs.areTouching(a, b);
    }
}
