package starlogo.intersection.sweep
{
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.BoxSegment;

    /**
     * When a capsule touches a box on its way: Newton's method on the distance from its segment to the box.
     *
     * @param capsule moves; it may have no length
     * @param box in the space of the capsule; half-extents may be 0
     * @param way of the capsule
     * @return from 0 to 1, or RelativeMotion.NEVER
     *
     * @private
     */
    public function capsuleBoxImpact(capsule:Capsule, box:Box, way:RelativeMotion):Number
    {
        var segment:BoxSegment = BoxSegment.SCRATCH;
        segment.relate(capsule, box);
        segment.turn(way.startX, way.startY, way.startZ);
        var fromX:Number = segment.x + segment.wayX;
        var fromY:Number = segment.y + segment.wayY;
        var fromZ:Number = segment.z + segment.wayZ;
        segment.turn(way.x, way.y, way.z);
        var wayX:Number = segment.wayX;
        var wayY:Number = segment.wayY;
        var wayZ:Number = segment.wayZ;
        segment.end();
        var alongX:Number = segment.alongX;
        var alongY:Number = segment.alongY;
        var alongZ:Number = segment.alongZ;
        var halfX:Number = box.halfX;
        var halfY:Number = box.halfY;
        var halfZ:Number = box.halfZ;
        var radius:Number = capsule.radius;
        var reach:Number = radius * Tolerances.TOUCHING + way.rounding();
        reach *= reach;
        var time:Number = 0;
        for (var step:int = 0; step < Newton.MOST_STEPS; step++)
        {
            var x:Number = fromX + time * wayX;
            var y:Number = fromY + time * wayY;
            var z:Number = fromZ + time * wayZ;
            var along:Number = segment.nearest(x, y, z, halfX, halfY, halfZ);
            x += along * alongX;
            x = x > halfX ? x - halfX : (x < -halfX ? x + halfX : 0);
            y += along * alongY;
            y = y > halfY ? y - halfY : (y < -halfY ? y + halfY : 0);
            z += along * alongZ;
            z = z > halfZ ? z - halfZ : (z < -halfZ ? z + halfZ : 0);
            var squared:Number = x * x + y * y + z * z;
            var closing:Number = -(x * wayX + y * wayY + z * wayZ);
            if (squared <= reach)
            {
                return Newton.lastStep(time, squared, reach, radius, closing);
            }
            var next:Number = Newton.next(time, squared, radius, closing);
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
