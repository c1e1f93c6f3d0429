package starlogo.intersection
{
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.RoundGap;

    /**
     * Finds the gap between two segments (Ericson, "Real-Time Collision Detection", §5.1.9).
     *
     * @param segments the segments, u and v
     * @param out receives the vector from the closest point of v to that of u, and the share of u
     * @private
     */
    internal function findSegmentGap(segments:SegmentPair, out:RoundGap):void
    {
        var x:Number = segments.x;
        var y:Number = segments.y;
        var z:Number = segments.z;
        var ux:Number = segments.ux;
        var uy:Number = segments.uy;
        var uz:Number = segments.uz;
        var vx:Number = segments.vx;
        var vy:Number = segments.vy;
        var vz:Number = segments.vz;
        include "segmentToSegment.inc";
        out.share = s;
        out.x = x + s * ux - t * vx;
        out.y = y + s * uy - t * vy;
        out.z = z + s * uz - t * vz;
    }
}
