package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;

    /** Thesis §3.6.7, written literally: six axes; the capsule's interval is widened by its radius. */
    public function capsuleBox(capsule:Capsule, box:Box):Boolean
    {
        var axes:Vector.<Vector3D> = Vector.<Vector3D>([box.axisX, box.axisY, box.axisZ]);
        var along:Vector3D = capsule.end.subtract(capsule.start);
        var corners:Vector.<Vector3D> = cornersOf(box);
        for (var i:int = 0; i < 3; i++)
        {
            if (areSeparated(axes[i], capsule, corners))
            {
                return false;
            }
        }
        for (i = 0; i < 3; i++)
        {
            var axis:Vector3D = axes[i].crossProduct(along);
            axis.normalize();
            if (areSeparated(axis, capsule, corners))
            {
                return false;
            }
        }
        return true;
    }
}

import flash.geom.Vector3D;
import starlogo.bounding.Capsule;

/** Whether an axis of length 1 separates the projections of a capsule and of corners. */
function areSeparated(axis:Vector3D, capsule:Capsule, corners:Vector.<Vector3D>):Boolean
{
    var start:Number = capsule.start.dotProduct(axis);
    var end:Number = capsule.end.dotProduct(axis);
    var min:Number = Infinity;
    var max:Number = -Infinity;
    for (var i:int = 0; i < 8; i++)
    {
        var corner:Number = corners[i].dotProduct(axis);
        min = Math.min(min, corner);
        max = Math.max(max, corner);
    }
    return Math.max(start, end) + capsule.radius < min || max < Math.min(start, end) - capsule.radius;
}
