package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * A copy of a fitted structure, wider by the distance at which surfaces still count as touching (Tolerances.SURFACES). So if the
     * surfaces of two models touch, their structures touch too. This holds for flat and thin structures as well. A sphere is copied
     * unchanged: its radius is never small compared with the model, so the tests' own tolerance is enough.
     *
     * @param structure a sphere, a capsule or a box
     *
     * @private
     */
    internal function widened(structure:BoundingStructure):BoundingStructure
    {
        // The tolerance depends on the model's radius about the middle of its extents. That radius is at most the square root of 3 times
        // the radius of a sphere around the model.
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
