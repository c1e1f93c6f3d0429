package evaluation.literal
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /** The sphere around a box or a capsule, for a preliminary test (thesis §7.5). */
    public function sphereAround(structure:BoundingStructure):Sphere
    {
        var box:Box = structure as Box;
        if (box != null)
        {
            return new Sphere(box.center, Math.sqrt(box.halfX * box.halfX + box.halfY * box.halfY + box.halfZ * box.halfZ));
        }
        var capsule:Capsule = structure as Capsule;
        var half:Number = capsule.end.subtract(capsule.start).length / 2;
        return new Sphere(between(capsule.start, capsule.end), half + capsule.radius);
    }
}

import flash.geom.Vector3D;

function between(a:Vector3D, b:Vector3D):Vector3D
{
    return new Vector3D((a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2);
}
