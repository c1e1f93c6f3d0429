package starlogo.intersection.ray
{
    import starlogo.bounding.BoundingStructure;

    /**
     * Adds where a ray enters a structure and where it leaves it. If it begins inside, it enters where it begins. If it ends inside, it does not
     * leave.
     *
     * @param ray in the space of the structure; it is not changed
     * @param structure see rayStructure
     * @param slack how far a place may be wrong because of rounding
     * @param part is overwritten
     * @param convex see rayStructure
     * @param out the crossings are added to it
     * @private
     */
    public function crossStructure(ray:Ray, structure:BoundingStructure, slack:Number, part:Ray, convex:ConvexRay, out:RayCrossings):void
    {
        part.copyFrom(ray);
        part.faceBack();
        if (!rayStructure(part, structure, convex))
        {
            return;
        }
        var entered:Number = part.from;
        out.addBeginning(part, entered > ray.from ? slack : 0, RayCrossings.ENTERS);
        // the same line in the other direction enters where the ray leaves
        part.copyFrom(ray);
        part.to = Infinity;
        part.turnRound();
        part.faceBack();
        rayStructure(part, structure, convex);
        part.turnRound();
        if (part.to <= ray.to)
        {
            part.setNormal(part.normalX, part.normalY, part.normalZ);
            part.from = part.to > entered ? part.to : entered;
            out.addBeginning(part, slack, RayCrossings.LEAVES);
        }
    }
}
