package starlogo.intersection
{
    import starlogo.geometry.Placement;

    /**
     * The axes of box b in the axes of box a, and their absolute values: what all pairs of boxes of two trees have in common.
     *
     * @private
     */
    public final class BoxAxes
    {
        /**
         * The axes of b. The first letter is a's axis, the second is b's: xy is the component of b's axisY along a's axisX.
         */
        public var xx:Number = 1;
        public var xy:Number = 0;
        public var xz:Number = 0;
        public var yx:Number = 0;
        public var yy:Number = 1;
        public var yz:Number = 0;
        public var zx:Number = 0;
        public var zy:Number = 0;
        public var zz:Number = 1;

        /** The absolute values of the axes. */
        public var absXx:Number = 1;
        public var absXy:Number = 0;
        public var absXz:Number = 0;
        public var absYx:Number = 0;
        public var absYy:Number = 1;
        public var absYz:Number = 0;
        public var absZx:Number = 0;
        public var absZy:Number = 0;
        public var absZz:Number = 1;

        /** Reads the axes of b from its rotation in the space of a, whose axes are those of the space, and multiplies them by a length. */
        public function readAxes(rotation:Placement, length:Number):void
        {
            xx = rotation.r00 * length;
            xy = rotation.r01 * length;
            xz = rotation.r02 * length;
            yx = rotation.r10 * length;
            yy = rotation.r11 * length;
            yz = rotation.r12 * length;
            zx = rotation.r20 * length;
            zy = rotation.r21 * length;
            zz = rotation.r22 * length;
            measureAxes();
        }

        /** Computes the absolute values. The axes must be set. */
        public function measureAxes():void
        {
            absXx = xx < 0 ? -xx : xx;
            absXy = xy < 0 ? -xy : xy;
            absXz = xz < 0 ? -xz : xz;
            absYx = yx < 0 ? -yx : yx;
            absYy = yy < 0 ? -yy : yy;
            absYz = yz < 0 ? -yz : yz;
            absZx = zx < 0 ? -zx : zx;
            absZy = zy < 0 ? -zy : zy;
            absZz = zz < 0 ? -zz : zz;
        }
    }
}
