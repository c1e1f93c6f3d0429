package starlogo.intersection.ray
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;

    use namespace engine;

    /**
     * Finds where a ray enters a structure. Allocates nothing, except at the first ray that meets a hull where it is.
     *
     * @param ray in the space of the structure
     * @param structure a sphere, a capsule, a box, a hull, or another convex structure
     * @param convex tests convex structures without half-spaces, which are further structures of the engine; null if there are none
     * @param out receives the distance and the normal
     * @return whether the ray meets the structure
     * @throws ArgumentError for any other structure
     * @private
     */
    public function rayStructure(ray:Ray, structure:BoundingStructure, convex:ConvexRay, out:RayEntry):Boolean
    {
        switch (structure.kind)
        {
            case BoundingStructure.SPHERE:
                return raySphere(ray, Sphere(structure), out);
            case BoundingStructure.CAPSULE:
                return rayCapsule(ray, Capsule(structure), out);
            case BoundingStructure.BOX:
                return rayBox(ray, Box(structure), out);
            case BoundingStructure.HULL:
                // "is Hull" would load Hull, and with it the search for convex hulls, into every game on the ES module that has rays. A type or a
                // cast loads nothing.
                if (structure.halfSpaces != null)
                {
                    return rayHull(ray, Hull(structure), out);
                }
                if (convex != null)
                {
                    return convex.enter(ray, structure, out);
                }
                break;
        }
        throw new ArgumentError("there is no test of rays for " + structure);
    }
}
