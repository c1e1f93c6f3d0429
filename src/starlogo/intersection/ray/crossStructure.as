package starlogo.intersection.ray
{
    import starlogo.bounding.BoundingStructure;

    /**
     * Adds where a ray enters a structure and where it leaves it. If it begins inside, it enters where it begins. If it ends inside, it does not
     * leave.
     *
     * @param ray in the space of the structure
     * @param structure see rayStructure
     * @param slack how far a distance may be wrong because of rounding
     * @param reversed is overwritten
     * @param entry is overwritten
     * @param convex see rayStructure
     * @param out the crossings are added to it
     * @private
     */
    public function crossStructure(ray:Ray, structure:BoundingStructure, slack:Number, reversed:Ray, entry:RayEntry, convex:ConvexRay, out:RayCrossings):void
    {
        if (!rayStructure(ray, structure, convex, entry))
        {
            return;
        }
        var entered:Number = entry.distance;
        out.addEntry(entry, entered > ray.from ? slack : 0, RayCrossings.ENTERS);
        // the same line in the other direction enters where the ray leaves
        reversed.setReversed(ray);
        if (rayStructure(reversed, structure, convex, entry) && -entry.distance <= ray.to)
        {
            entry.setNormal(ray, entry.normalX, entry.normalY, entry.normalZ);
            entry.distance = -entry.distance > entered ? -entry.distance : entered;
            out.addEntry(entry, slack, RayCrossings.LEAVES);
        }
    }
}
