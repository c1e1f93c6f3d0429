package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /** Writes a corner of a box. Its number has a bit for each axis along which it is on the far side. */
    public function cornerOf(box:Box, corner:int, out:Vector3D):void
    {
        var x:Number = (corner & 1) == 0 ? -box.halfX : box.halfX;
        var y:Number = (corner & 2) == 0 ? -box.halfY : box.halfY;
        var z:Number = (corner & 4) == 0 ? -box.halfZ : box.halfZ;
        out.setTo(box.center.x + x * box.axisX.x + y * box.axisY.x + z * box.axisZ.x, box.center.y + x * box.axisX.y + y * box.axisY.y
                + z * box.axisZ.y, box.center.z + x * box.axisX.z + y * box.axisY.z + z * box.axisZ.z);
    }
}
