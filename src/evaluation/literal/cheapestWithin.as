package evaluation.literal
{
    import starlogo.bounding.BoundingStructure;

    /**
     * The structure with the cheapest tests among those of at most factor times the least volume (thesis §7.4).
     *
     * @param structures a sphere, a capsule and a box around a model, in this order: spheres have the cheapest tests
     */
    public function cheapestWithin(structures:Array, factor:Number):BoundingStructure
    {
        var least:Number = Math.min(structures[0].volume, structures[1].volume, structures[2].volume);
        for each (var structure:BoundingStructure in structures)
        {
            if (structure.volume <= factor * least)
            {
                return structure;
            }
        }
        throw new ArgumentError("the factor must be at least 1, not " + factor);
    }
}
