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
            if (areSeparated(axesA[i], cornersA, cornersB) || areSeparated(axesB[i], cornersA, cornersB))
            {
                return false;
            }
        }
        for (i = 0; i < 3; i++)
        {
            for (var j:int = 0; j < 3; j++)
            {
                if (areSeparated(axesA[i].crossProduct(axesB[j]), cornersA, cornersB))
                {
                    return false;
                }
            }
        }
        return true;
    }
}

import flash.geom.Vector3D;

/** Whether an axis separates the projections of two sets of corners. */
function areSeparated(axis:Vector3D, cornersA:Vector.<Vector3D>, cornersB:Vector.<Vector3D>):Boolean
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
