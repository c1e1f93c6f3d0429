package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.SegmentPair;

    /**
     * When a capsule touches another on its way: Newton's method on the distance of their segments.
     *
     * @param a moves; it may have no length
     * @param b in the space of a; likewise
     * @param way of a
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function capsuleCapsuleImpact(a:Capsule, b:Capsule, way:RelativeMotion):Number
    {
        var segments:SegmentPair = SegmentPair.SCRATCH;
        segments.relate(a, b);
        var fromX:Number = segments.x + way.startX;
        var fromY:Number = segments.y + way.startY;
        var fromZ:Number = segments.z + way.startZ;
        var wayX:Number = way.x;
        var wayY:Number = way.y;
        var wayZ:Number = way.z;
        var radii:Number = a.radius + b.radius;
        var reach:Number = radii * Tolerances.TOUCHING + way.rounding();
        reach *= reach;
        var time:Number = 0;
        for (var step:int = 0; step < Newton.MOST_STEPS; step++)
        {
            segments.findNearest(fromX + time * wayX, fromY + time * wayY, fromZ + time * wayZ);
            var x:Number = segments.gapX;
            var y:Number = segments.gapY;
            var z:Number = segments.gapZ;
            var squared:Number = x * x + y * y + z * z;
            var closing:Number = -(x * wayX + y * wayY + z * wayZ);
            if (squared <= reach)
            {
                return Newton.lastStep(time, squared, reach, radii, closing);
            }
            var next:Number = Newton.next(time, squared, radii, closing);
            if (!(next > time))
            {
                return time;
            }
            if (next > 1)
            {
                return RelativeMotion.NEVER;
            }
            time = next;
        }
        return time;
    }
}
