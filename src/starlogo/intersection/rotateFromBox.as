package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.intersection.distance.RoundGap;

    /** Rotates a gap from a box's axes into the axes of the box's space. */
    internal function rotateFromBox(box:Box, gap:RoundGap):void
    {
        var axisX:Vector3D = box.axisX;
        var axisY:Vector3D = box.axisY;
        var axisZ:Vector3D = box.axisZ;
        var x:Number = gap.x;
        var y:Number = gap.y;
        var z:Number = gap.z;
        gap.x = x * axisX.x + y * axisY.x + z * axisZ.x;
        gap.y = x * axisX.y + y * axisY.y + z * axisZ.y;
        gap.z = x * axisX.z + y * axisY.z + z * axisZ.z;
    }
}
