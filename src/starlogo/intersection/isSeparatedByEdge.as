package starlogo.intersection
{
    import starlogo.bounding.Box;

    /**
     * Whether the cross product of edge p of the other box and one of a's separates; q and r are the other box's other edges,
     * half of each, all in a's axes.
     *
     * @private
     */
    internal function isSeparatedByEdge(a:Box, tX:Number, tY:Number, tZ:Number, pX:Number, pY:Number, pZ:Number,
            qX:Number, qY:Number, qZ:Number, rX:Number, rY:Number, rZ:Number):Boolean
    {
        var x:Number = Math.abs(pX);
        var y:Number = Math.abs(pY);
        var z:Number = Math.abs(pZ);
        var reachX:Number = a.halfY * z + a.halfZ * y + Math.abs(qZ * pY - qY * pZ) + Math.abs(rZ * pY - rY * pZ);
        var reachY:Number = a.halfZ * x + a.halfX * z + Math.abs(qX * pZ - qZ * pX) + Math.abs(rX * pZ - rZ * pX);
        var reachZ:Number = a.halfX * y + a.halfY * x + Math.abs(qY * pX - qX * pY) + Math.abs(rY * pX - rX * pY);
        return Math.abs(tZ * pY - tY * pZ) > reachX || Math.abs(tX * pZ - tZ * pX) > reachY
            || Math.abs(tY * pX - tX * pY) > reachZ;
    }
}
