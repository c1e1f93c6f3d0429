package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.geometry.Tolerances;

    /**
     * Whether a structure contains all vertices of a model, as precisely as a fit has to (Tolerances.CONTAINMENT): whether the tightest one
     * of its position is no wider. The tolerance is in proportion to the model's size, not to that of the structure, which may be forged. One to
     * three passes over the vertices.
     *
     * @param structure a sphere, a capsule or a box
     * @param vertices x, y, z each
     *
     * @private
     */
    internal function encloses(structure:BoundingStructure, vertices:Vector.<Number>):Boolean
    {
        var sphere:Sphere = structure as Sphere;
        var capsule:Capsule = structure as Capsule;
        var box:Box = structure as Box;
        try
        {
            var slack:Number = 0;
            if (box == null)
            {
                slack = Tolerances.CONTAINMENT * EnclosingStructures.sphere(vertices, vertices[0], vertices[1], vertices[2]).radius;
            }
            if (sphere != null)
            {
                var ball:Sphere = EnclosingStructures.sphere(vertices, sphere.center.x, sphere.center.y, sphere.center.z);
                return ball.radius <= sphere.radius + slack;
            }
            if (capsule != null)
            {
                var axis:Vector3D = capsule.end.subtract(capsule.start);
                var length:Number = axis.normalize();
                var radius:Number = Math.max(capsule.radius, EnclosingStructures.distanceFromLine(vertices, capsule.start, axis));
                var longer:Capsule = EnclosingStructures.capsule(vertices, capsule.start, axis, 0, length, radius);
                return radius <= capsule.radius + slack && Vector3D.distance(longer.start, capsule.start) <= slack
                    && Vector3D.distance(longer.end, capsule.end) <= slack;
            }
            var axes:Vector.<Number> = new <Number>[box.axisX.x, box.axisX.y, box.axisX.z, box.axisY.x, box.axisY.y, box.axisY.z,
                    box.axisZ.x, box.axisZ.y, box.axisZ.z];
            var tight:Box = EnclosingStructures.box(vertices, axes);
            var apart:Vector3D = tight.center.subtract(box.center);
            slack = Tolerances.CONTAINMENT * Math.max(tight.halfX, tight.halfY, tight.halfZ);
            return Math.abs(apart.dotProduct(box.axisX)) + tight.halfX <= box.halfX + slack
                && Math.abs(apart.dotProduct(box.axisY)) + tight.halfY <= box.halfY + slack
                && Math.abs(apart.dotProduct(box.axisZ)) + tight.halfZ <= box.halfZ + slack;
        }
        catch (error:RangeError)
        {
            // of coordinates so large that distances are not finite
        }
        return false;
    }
}
