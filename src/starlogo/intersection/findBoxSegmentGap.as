package starlogo.intersection
{
    import starlogo.intersection.distance.RoundGap;

    /**
     * Finds the gap between a segment and a box.
     *
     * @param segment the segment in the box's mirrored axes
     * @param out receives the vector from the box's closest point to the segment's, in the same axes, and the share of the segment. If several
     *     points are closest, the one in the middle of them is taken
     * @private
     */
    internal function findBoxSegmentGap(segment:BoxSegment, out:RoundGap):void
    {
        var px:Number = segment.x;
        var py:Number = segment.y;
        var pz:Number = segment.z;
        var halfX:Number = segment.halfX;
        var halfY:Number = segment.halfY;
        var halfZ:Number = segment.halfZ;
        var dx:Number = segment.alongX;
        var dy:Number = segment.alongY;
        var dz:Number = segment.alongZ;
        include "segmentToBox.inc";
        if (lastIn <= firstOut)
        {
            lastIn = lastIn > 0 ? (lastIn < 1 ? lastIn : 1) : 0;
            firstOut = firstOut > 0 ? (firstOut < 1 ? firstOut : 1) : 0;
            t = (lastIn + firstOut) / 2;
        }
        // The comparison is false for NaN too.
        t = t > 0 ? (t < 1 ? t : 1) : 0;
        var x:Number = px + t * dx;
        var y:Number = py + t * dy;
        var z:Number = pz + t * dz;
        include "pointToBox.inc";
        out.share = t;
        out.x = x;
        out.y = y;
        out.z = z;
    }
}
