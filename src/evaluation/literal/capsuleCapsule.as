package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;

    /** Thesis §3.6.3, written literally: the closest points of the two lines. Each point is clamped to its own segment. */
    public function capsuleCapsule(a:Capsule, b:Capsule):Boolean
    {
        var alongA:Vector3D = a.end.subtract(a.start);
        var alongB:Vector3D = b.end.subtract(b.start);
        var between:Vector3D = a.start.subtract(b.start);
        var c1:Number = alongA.dotProduct(alongB);
        var c2:Number = alongA.dotProduct(alongA);
        var c3:Number = alongB.dotProduct(alongB);
        var c4:Number = alongA.dotProduct(between);
        var c5:Number = alongB.dotProduct(between);
        var denominator:Number = c2 * c3 - c1 * c1;
        var closestA:Number = 0;
        var closestB:Number = c5 / c3;
        if (denominator != 0)
        {
            closestA = (c1 * c5 - c3 * c4) / denominator;
            closestB = (c2 * c5 - c1 * c4) / denominator;
        }
        alongA.scaleBy(Math.max(0, Math.min(1, closestA)));
        alongB.scaleBy(Math.max(0, Math.min(1, closestB)));
        var apart:Vector3D = a.start.add(alongA).subtract(b.start.add(alongB));
        var reach:Number = a.radius + b.radius;
        return apart.lengthSquared <= reach * reach;
    }
}
