package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;

    /**
     * The contact of two spheres, as ContactFinder describes it.
     *
     * @param a one of them
     * @param b the other, in the same space
     * @param x how far a is displaced from where it stands
     * @param y likewise
     * @param z likewise
     * @param out takes the result
     *
     * @private
     */
    public function contactOfSpheres(a:Sphere, b:Sphere, x:Number, y:Number, z:Number, out:ContactPoint):void
    {
        var center:Vector3D = a.center;
        var middle:Vector3D = b.center;
        x += center.x;
        y += center.y;
        z += center.z;
        var depth:Number = a.radius + b.radius;
        var gapX:Number = x - middle.x;
        var gapY:Number = y - middle.y;
        var gapZ:Number = z - middle.z;
        // the difference of two points has a direction however short it is
        if (gapX * gapX + gapY * gapY + gapZ * gapZ > 0)
        {
            depth -= out.pointAlong(gapX, gapY, gapZ);
        }
        else
        {
            out.pointAlong(0, 0, 1);
        }
        out.place(x, y, z, a.radius, depth);
    }
}
