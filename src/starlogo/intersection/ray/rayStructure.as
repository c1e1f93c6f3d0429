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
     * Narrows a ray to the part inside of a structure. Allocates nothing, except at the first ray that meets a hull where it is.
     *
     * @param ray in the space of the structure; its part is narrowed, and its normal is set if it enters the structure
     * @param structure a sphere, a capsule, a box, a hull, or another convex structure
     * @param convex tests convex structures without half-spaces, which are further structures of the engine; null if there are none
     * @return whether the ray meets the structure
     * @throws ArgumentError for any other structure
     * @private
     */
    public function rayStructure(ray:Ray, structure:BoundingStructure, convex:ConvexRay = null):Boolean
    {
        switch (structure.kind)
        {
            case BoundingStructure.SPHERE:
                return raySphere(ray, Sphere(structure));
            case BoundingStructure.CAPSULE:
                return rayCapsule(ray, Capsule(structure));
            case BoundingStructure.BOX:
                return rayBox(ray, Box(structure));
            case BoundingStructure.HULL:
                // "is Hull" would bring the search for hulls into every game with rays
                if (structure.halfSpaces != null)
                {
                    return rayHull(ray, Hull(structure));
                }
                if (convex != null)
                {
                    return convex.narrow(ray, structure);
                }
                break;
        }
        throw new ArgumentError("there is no test of rays for " + structure);
    }
}
