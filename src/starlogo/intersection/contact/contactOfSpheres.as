package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * The contact of two spheres, as ContactFinder describes it.
     *
     * @param a one of them
     * @param b the other, in the same space
     * @param displacement where a is, from where it stands: the motion's start
     * @param out takes the result
     *
     * @private
     */
    public function contactOfSpheres(a:Sphere, b:Sphere, displacement:RelativeMotion, out:ContactPoint):void
    {
        var center:Vector3D = a.center;
        var middle:Vector3D = b.center;
        var x:Number = displacement.startX + center.x;
        var y:Number = displacement.startY + center.y;
        var z:Number = displacement.startZ + center.z;
        var gapX:Number = x - middle.x;
        var gapY:Number = y - middle.y;
        var gapZ:Number = z - middle.z;
        out.x = x;
        out.y = y;
        out.z = z;
        out.radius = a.radius;
        out.depth = a.radius + b.radius;
        // the difference of two points has a direction however short it is
        if (gapX * gapX + gapY * gapY + gapZ * gapZ > 0)
        {
            out.setNormal(gapX, gapY, gapZ);
            out.normalise();
            out.depth -= out.length;
        }
        else
        {
            out.setNormal(0, 0, 1);
        }
        out.place();
    }
}
