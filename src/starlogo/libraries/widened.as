package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * A copy of a fitted structure that is wider by what surfaces may be apart and still touch (Tolerances.SURFACES): models
     * whose surfaces touch have structures that do, also flat and thin ones. A sphere is as it was: its radius is never small
     * beside the model, so that the tests' own tolerance does.
     *
     * @param structure a sphere, a capsule or a box
     *
     * @private
     */
    internal function widened(structure:BoundingStructure):BoundingStructure
    {
        // a model's radius, about the middle of its extents, is at most the root of three times that of a sphere around it
        var copy:BoundingStructure = structure.clone();
        if (copy is Capsule)
        {
            var capsule:Capsule = Capsule(copy);
            capsule.radius += 2 * Tolerances.SURFACES * (capsule.radius + 0.5 * Vector3D.distance(capsule.start, capsule.end));
        }
        else if (copy is Box)
        {
            var box:Box = Box(copy);
            var margin:Number = 2 * Tolerances.SURFACES * (box.halfX + box.halfY + box.halfZ);
            box.halfX += margin;
            box.halfY += margin;
            box.halfZ += margin;
        }
        return copy;
    }
}
