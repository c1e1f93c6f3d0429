package starlogo.intersection.boxes
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    /**
     * The axes of box b in the axes of box a, and their absolute values, as a record. All pairs of boxes of two trees have them in common.
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

        /** Sets the axes of two boxes. They are the cosines of the angles between the axes of b and those of a. */
        public function setTo(a:Box, b:Box):void
        {
            var bX:Vector3D = b.axisX;
            var bY:Vector3D = b.axisY;
            var bZ:Vector3D = b.axisZ;
            var axis:Vector3D = a.axisX;
            m00 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            m01 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            m02 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            axis = a.axisY;
            m10 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            m11 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            m12 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            axis = a.axisZ;
            m20 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            m21 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            m22 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            measureAxes(0);
        }

        /**
         * Reads the axes of b from its rotation in the space of a, whose axes are those of the space.
         *
         * @param slack is added to the absolute values
         */
        public function setAxes(rotation:Placement, slack:Number = 0):void
        {
            m00 = rotation.r00;
            m01 = rotation.r01;
            m02 = rotation.r02;
            m10 = rotation.r10;
            m11 = rotation.r11;
            m12 = rotation.r12;
            m20 = rotation.r20;
            m21 = rotation.r21;
            m22 = rotation.r22;
            measureAxes(slack);
        }

        /** Whether edges of the two boxes are so nearly parallel that their cross product would cancel. */
        public function get areNearlyParallel():Boolean
        {
            var near:Number = 1 - Tolerances.NEARLY_PARALLEL / 2;
            return abs22 > near || abs21 > near || abs20 > near
                || abs12 > near || abs11 > near || abs10 > near
                || abs02 > near || abs01 > near || abs00 > near;
        }

        /** Whether the z axes of the two boxes are parallel. Then their faces are enough: the cross products of other edges are along z or across it. */
        public function get areZAxesParallel():Boolean
        {
            return m02 * m02 + m12 * m12 <= Tolerances.PARALLEL;
        }

        private function measureAxes(slack:Number):void
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
