package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /** The eight corners of a box. */
    public function cornersOf(box:Box):Vector.<Vector3D>
    {
        var x:Vector3D = box.axisX.clone();
        var y:Vector3D = box.axisY.clone();
        var z:Vector3D = box.axisZ.clone();
        x.scaleBy(box.halfX);
        y.scaleBy(box.halfY);
        z.scaleBy(box.halfZ);
        var right:Vector3D = box.center.add(x);
        var left:Vector3D = box.center.subtract(x);
        return Vector.<Vector3D>([
                    right.add(y).add(z), right.add(y).subtract(z), right.subtract(y).add(z), right.subtract(y).subtract(z),
                    left.add(y).add(z), left.add(y).subtract(z), left.subtract(y).add(z), left.subtract(y).subtract(z)]);
    }
}
