package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * Whether two structures touch or overlap (thesis §3.6). Symmetric. This package has a function for each pair of spheres, capsules and boxes.
     * From the fastest to the slowest, these are: sphereSphere, sphereCapsule, sphereBox, capsuleCapsule, capsuleBox, boxBox. They allocate
     * nothing. A test with a hull finds the distance of two convex shapes.
     *
     * @param a a Sphere, Capsule, Box or Hull
     * @param b a Sphere, Capsule, Box or Hull, in the same space
     * @throws ArgumentError if there is no test for the pair, because cylinders are fitted but never collided (thesis §3.6.1)
     * @throws TypeError if a or b is null
     */
    public function intersects(a:BoundingStructure, b:BoundingStructure):Boolean
    {
        if (a.kind > b.kind)
        {
            var first:BoundingStructure = b;
            b = a;
            a = first;
        }
        switch (a.kind)
        {
            case BoundingStructure.SPHERE:
                switch (b.kind)
                {
                    case BoundingStructure.SPHERE:
                        return sphereSphere(a as Sphere, b as Sphere);
                    case BoundingStructure.CAPSULE:
                        return sphereCapsule(a as Sphere, b as Capsule);
                    case BoundingStructure.BOX:
                        return sphereBox(a as Sphere, b as Box);
                }
                break;
            case BoundingStructure.CAPSULE:
                switch (b.kind)
                {
                    case BoundingStructure.CAPSULE:
                        return capsuleCapsule(a as Capsule, b as Capsule);
                    case BoundingStructure.BOX:
                        return capsuleBox(a as Capsule, b as Box);
                }
                break;
            case BoundingStructure.BOX:
                if (b.kind == BoundingStructure.BOX)
                {
                    return boxBox(a as Box, b as Box);
                }
        }
        return PairTable.kernelOf(a, b).areTouching(a, b);
    }
}
