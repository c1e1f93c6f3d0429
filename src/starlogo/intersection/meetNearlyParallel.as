package starlogo.intersection
{
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.boxBoxImpact;

    /**
     * Whether two boxes meet that their faces do not separate, where an edge of one is nearly parallel to one of the other. With one pair
     * of edges parallel, every cross product is the direction of a face, which has been tried; else the sweep's axes are taken, which do
     * not cancel.
     *
     * @param cosXX the dot product of a's axisX and b's axisX; the others alike, a's axis first
     *
     * @private
     */
    internal function meetNearlyParallel(a:Box, b:Box, cosXX:Number, cosXY:Number, cosXZ:Number, cosYX:Number, cosYY:Number,
            cosYZ:Number, cosZX:Number, cosZY:Number, cosZZ:Number):Boolean
    {
        var xx:Number = cosXX * cosXX;
        var xy:Number = cosXY * cosXY;
        var xz:Number = cosXZ * cosXZ;
        var yx:Number = cosYX * cosYX;
        var yy:Number = cosYY * cosYY;
        var yz:Number = cosYZ * cosYZ;
        var zx:Number = cosZX * cosZX;
        var zy:Number = cosZY * cosZY;
        var zz:Number = cosZZ * cosZZ;
        var limit:Number = Tolerances.PARALLEL;
        return xz + yz <= limit || yx + zx <= limit || xy + zy <= limit
            || yy + zy <= limit || yz + zz <= limit || xx + zx <= limit || xz + zz <= limit
            || xx + yx <= limit || xy + yy <= limit || boxBoxImpact(a, b, RelativeMotion.NONE) == 0;
    }
}
