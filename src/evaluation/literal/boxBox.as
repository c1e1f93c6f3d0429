package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /** Thesis §3.6.4, written literally: the eight corners of both boxes on up to fifteen axes. */
    public function boxBox(a:Box, b:Box):Boolean
    {
        var axesA:Vector.<Vector3D> = Vector.<Vector3D>([a.axisX, a.axisY, a.axisZ]);
        var axesB:Vector.<Vector3D> = Vector.<Vector3D>([b.axisX, b.axisY, b.axisZ]);
        var cornersA:Vector.<Vector3D> = cornersOf(a);
        var cornersB:Vector.<Vector3D> = cornersOf(b);
        for (var i:int = 0; i < 3; i++)
        {
            if (separates(axesA[i], cornersA, cornersB) || separates(axesB[i], cornersA, cornersB))
            {
                return false;
            }
        }
        for (i = 0; i < 3; i++)
        {
            for (var j:int = 0; j < 3; j++)
            {
                if (separates(axesA[i].crossProduct(axesB[j]), cornersA, cornersB))
                {
                    return false;
                }
            }
        }
        return true;
    }
}
