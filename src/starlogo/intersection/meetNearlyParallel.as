package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findBoxImpact;

    /**
     * Whether two boxes touch. Only for boxes that no face separates, and that have two nearly parallel edges, one of each box.
     *
     * <p>If two edges are exactly parallel, every cross product is the direction of a face, which has been tried already. Otherwise this
     * uses the sweep's axes, which do not cancel. The nine cosines are computed again, because V8 would allocate an object for each Number
     * that is passed.</p>
     *
     * @private
     */
    internal function meetNearlyParallel(a:Box, b:Box):Boolean
    {
        var limit:Number = Tolerances.PARALLEL;
        var axisX:Vector3D = a.axisX;
        var axisY:Vector3D = a.axisY;
        var axisZ:Vector3D = a.axisZ;
        for (var i:int = 0; i < 3; i++)
        {
            var axis:Vector3D = b.axisZ;
            if (i > 0)
            {
                axis = i == 1 ? b.axisX : b.axisY;
            }
            var x:Number = axisX.x * axis.x + axisX.y * axis.y + axisX.z * axis.z;
            var y:Number = axisY.x * axis.x + axisY.y * axis.y + axisY.z * axis.z;
            var z:Number = axisZ.x * axis.x + axisZ.y * axis.y + axisZ.z * axis.z;
            x *= x;
            y *= y;
            z *= z;
            // The axis is along one axis of a, because its components along the other two are 0.
            if (x + y <= limit || y + z <= limit || x + z <= limit)
            {
                return true;
            }
        }
        findBoxImpact(a, b, RelativeMotion.NONE);
        return RelativeMotion.NONE.time == 0;
    }
}
