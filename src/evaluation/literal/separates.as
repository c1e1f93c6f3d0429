package evaluation.literal
{
    import flash.geom.Vector3D;

    /** Whether an axis separates the projections of the corners of two boxes. */
    public function separates(axis:Vector3D, cornersA:Vector.<Vector3D>, cornersB:Vector.<Vector3D>):Boolean
    {
        var minA:Number = Infinity;
        var maxA:Number = -Infinity;
        var minB:Number = Infinity;
        var maxB:Number = -Infinity;
        for (var i:int = 0; i < 8; i++)
        {
            var a:Number = cornersA[i].dotProduct(axis);
            var b:Number = cornersB[i].dotProduct(axis);
            minA = Math.min(minA, a);
            maxA = Math.max(maxA, a);
            minB = Math.min(minB, b);
            maxB = Math.max(maxB, b);
        }
        return maxA < minB || maxB < minA;
    }
}
