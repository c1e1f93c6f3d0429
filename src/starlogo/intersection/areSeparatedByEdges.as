package starlogo.intersection
{
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;

    /**
     * Whether the cross product of an edge of a and one of b separates two boxes that their faces do not: for boxes with
     * nearly parallel edges, where the usual formulas cancel.
     *
     * <p>b's axes are taken as they were rounded, and each cross product is an axis like any other: what is projected on
     * it shrinks with its length, and so do the rounding errors.</p>
     *
     * @param tX the way from a's centre to b's, in a's axes
     * @param cosXX the dot product of a's axisX and b's axisX; the others alike, a's axis first
     *
     * @private
     */
    internal function areSeparatedByEdges(a:Box, b:Box, tX:Number, tY:Number, tZ:Number,
            cosXX:Number, cosXY:Number, cosXZ:Number, cosYX:Number, cosYY:Number, cosYZ:Number,
            cosZX:Number, cosZY:Number, cosZZ:Number):Boolean
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
        // With one pair of edges parallel, every other cross product is the direction of a face, which has been tried.
        if (xz + yz <= limit || yx + zx <= limit || xy + zy <= limit
                || yy + zy <= limit || yz + zz <= limit || xx + zx <= limit || xz + zz <= limit
                || xx + yx <= limit || xy + yy <= limit)
        {
            return false;
        }
        var halfX:Number = b.halfX;
        var halfY:Number = b.halfY;
        var halfZ:Number = b.halfZ;
        return isSeparatedByEdge(a, tX, tY, tZ, cosXX, cosYX, cosZX,
                halfY * cosXY, halfY * cosYY, halfY * cosZY, halfZ * cosXZ, halfZ * cosYZ, halfZ * cosZZ)
            || isSeparatedByEdge(a, tX, tY, tZ, cosXY, cosYY, cosZY,
                halfZ * cosXZ, halfZ * cosYZ, halfZ * cosZZ, halfX * cosXX, halfX * cosYX, halfX * cosZX)
            || isSeparatedByEdge(a, tX, tY, tZ, cosXZ, cosYZ, cosZZ,
                halfX * cosXX, halfX * cosYX, halfX * cosZX, halfY * cosXY, halfY * cosYY, halfY * cosZY);
    }
}
