package starlogo.geometry
{
    /**
     * Transforms points, as Placement.place() transforms one.
     *
     * @param placement the transform
     * @param from x, y, z of each
     * @param first index of the first coordinate
     * @param end index after the last coordinate
     * @param out overwritten from an index on; stays longer if it had more points
     * @param to that index
     * @return out
     * @private
     */
    public function placePoints(placement:Placement, from:Vector.<Number>, first:int, end:int, out:Vector.<Number>, to:int = 0):Vector.<Number>
    {
        var scale:Number = placement.size;
        var m00:Number = placement.r00 * scale;
        var m01:Number = placement.r01 * scale;
        var m02:Number = placement.r02 * scale;
        var m10:Number = placement.r10 * scale;
        var m11:Number = placement.r11 * scale;
        var m12:Number = placement.r12 * scale;
        var m20:Number = placement.r20 * scale;
        var m21:Number = placement.r21 * scale;
        var m22:Number = placement.r22 * scale;
        for (var i:int = first; i < end; i += 3)
        {
            var fromX:Number = from[i];
            var fromY:Number = from[int(i + 1)];
            var fromZ:Number = from[int(i + 2)];
            out[to] = m00 * fromX + m01 * fromY + m02 * fromZ + placement.x;
            out[int(to + 1)] = m10 * fromX + m11 * fromY + m12 * fromZ + placement.y;
            out[int(to + 2)] = m20 * fromX + m21 * fromY + m22 * fromZ + placement.z;
            to += 3;
        }
        return out;
    }
}
