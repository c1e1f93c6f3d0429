package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /** Thesis §3.6.4, the first six axes alone: whether no face of two boxes separates them. */
    public function boxFaces(a:Box, b:Box):Boolean
    {
        var cornersA:Vector.<Vector3D> = cornersOf(a);
        var cornersB:Vector.<Vector3D> = cornersOf(b);
        for each (var axis:Vector3D in [a.axisX, a.axisY, a.axisZ, b.axisX, b.axisY, b.axisZ])
        {
            if (separates(axis, cornersA, cornersB))
            {
                return false;
            }
        }
        return true;
    }
}
