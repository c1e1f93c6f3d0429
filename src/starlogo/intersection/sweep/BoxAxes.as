package starlogo.intersection.sweep
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
         * The axes of b. The first digit counts the axes of a, the second those of b: m01 is the component of b's axisY along a's axisX.
         */
        public var m00:Number = 1;
        public var m01:Number = 0;
        public var m02:Number = 0;
        public var m10:Number = 0;
        public var m11:Number = 1;
        public var m12:Number = 0;
        public var m20:Number = 0;
        public var m21:Number = 0;
        public var m22:Number = 1;

        /** The absolute values of the axes. */
        public var abs00:Number = 1;
        public var abs01:Number = 0;
        public var abs02:Number = 0;
        public var abs10:Number = 0;
        public var abs11:Number = 1;
        public var abs12:Number = 0;
        public var abs20:Number = 0;
        public var abs21:Number = 0;
        public var abs22:Number = 1;

        /**
         * Reads the axes of b from its rotation in the space of a, whose axes are those of the space, and multiplies them by a length.
         *
         * @param slack how much larger the absolute values are
         */
        public function readAxes(rotation:Placement, length:Number, slack:Number = 0):void
        {
            m00 = rotation.r00 * length;
            m01 = rotation.r01 * length;
            m02 = rotation.r02 * length;
            m10 = rotation.r10 * length;
            m11 = rotation.r11 * length;
            m12 = rotation.r12 * length;
            m20 = rotation.r20 * length;
            m21 = rotation.r21 * length;
            m22 = rotation.r22 * length;
            measureAxes(slack);
        }

        /** Computes the absolute values, and adds a slack to them. The axes must be set. */
        public function measureAxes(slack:Number = 0):void
        {
            abs00 = m00 < 0 ? slack - m00 : slack + m00;
            abs01 = m01 < 0 ? slack - m01 : slack + m01;
            abs02 = m02 < 0 ? slack - m02 : slack + m02;
            abs10 = m10 < 0 ? slack - m10 : slack + m10;
            abs11 = m11 < 0 ? slack - m11 : slack + m11;
            abs12 = m12 < 0 ? slack - m12 : slack + m12;
            abs20 = m20 < 0 ? slack - m20 : slack + m20;
            abs21 = m21 < 0 ? slack - m21 : slack + m21;
            abs22 = m22 < 0 ? slack - m22 : slack + m22;
        }
    }
}
