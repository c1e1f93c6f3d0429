package starlogo.geometry
{
    /**
     * Scales and rotates points about their origin.
     *
     * @param placement has the size and the rotation
     * @param from x, y, z of each
     * @param out receives as many numbers; may be from
     * @private
     */
    public function scaleAndRotatePoints(placement:Placement, from:Vector.<Number>, out:Vector.<Number>):void
    {
        var scale:Number = placement.size;
        var end:int = from.length;
        for (var i:int = 0; i < end; i += 3)
        {
            var fromX:Number = from[i] * scale;
            var fromY:Number = from[int(i + 1)] * scale;
            var fromZ:Number = from[int(i + 2)] * scale;
            out[i] = placement.r00 * fromX + placement.r01 * fromY + placement.r02 * fromZ;
            out[int(i + 1)] = placement.r10 * fromX + placement.r11 * fromY + placement.r12 * fromZ;
            out[int(i + 2)] = placement.r20 * fromX + placement.r21 * fromY + placement.r22 * fromZ;
        }
    }
}
