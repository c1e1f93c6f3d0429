// The package intersection.boxes decides about two boxes by separating axes: the three of a, the three of b, and the nine across an edge of each
// (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996). Boxes are apart if one of these axes separates them. Two classes project the boxes on them,
// because they need different arithmetic. KernelsAgreeTest checks that both agree.
// 
// - BoxSeparation is for boxes that stand. An axis across edges takes a few products, which cancel if the edges are nearly parallel. Then boxBox asks
// BoxSweep.
// - BoxSweep is for boxes that move. Each axis gives an interval of time. It projects the boxes in full on the axes across edges, so nothing cancels,
// but that takes longer.
// 
// The depth of two boxes comes from SatPenetration, which knows the faces and edges of all convex shapes. Read BoxPair first.

package starlogo.intersection.boxes
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    /**
     * Two boxes, as a record: box b as seen from box a. All numbers are in the axes of a. All pairs of boxes of two trees have the same rotation and
     * margin. Then these are set once for all of them.
     *
     * @private
     */
    public final class BoxPair
    {
        /** The pair that <code>boxBox()</code> sets. */
        public static const SCRATCH:BoxPair = new BoxPair();

        /** The rotation of b: its columns are the axes of b. Nothing else of the placement counts. */
        public var rotation:Placement = new Placement();

        /** The absolute values of the rotation. */
        public var abs00:Number = 1;
        public var abs01:Number = 0;
        public var abs02:Number = 0;
        public var abs10:Number = 0;
        public var abs11:Number = 1;
        public var abs12:Number = 0;
        public var abs20:Number = 0;
        public var abs21:Number = 0;
        public var abs22:Number = 1;

        /** The gap across which the boxes still touch: the sum of the margins (see Touching). Only BoxSweep reads it. */
        public var margin:Number = 0;

        /** The vector from a's middle to b's, at time 0 if b moves. boxBox() shortens it in place of a margin. */
        public var offsetX:Number = 0;
        public var offsetY:Number = 0;
        public var offsetZ:Number = 0;

        /** The half-extents of a. */
        public var aHalfX:Number = 0;
        public var aHalfY:Number = 0;
        public var aHalfZ:Number = 0;

        /** The half-extents of b. */
        public var bHalfX:Number = 0;
        public var bHalfY:Number = 0;
        public var bHalfZ:Number = 0;

        /** Sets the rotation and the half-extents. */
        public function setBoxes(a:Box, b:Box):void
        {
            aHalfX = a.halfX;
            aHalfY = a.halfY;
            aHalfZ = a.halfZ;
            bHalfX = b.halfX;
            bHalfY = b.halfY;
            bHalfZ = b.halfZ;
            var bX:Vector3D = b.axisX;
            var bY:Vector3D = b.axisY;
            var bZ:Vector3D = b.axisZ;
            var axis:Vector3D = a.axisX;
            rotation.r00 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            rotation.r01 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            rotation.r02 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            axis = a.axisY;
            rotation.r10 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            rotation.r11 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            rotation.r12 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            axis = a.axisZ;
            rotation.r20 = axis.x * bX.x + axis.y * bX.y + axis.z * bX.z;
            rotation.r21 = axis.x * bY.x + axis.y * bY.y + axis.z * bY.z;
            rotation.r22 = axis.x * bZ.x + axis.y * bZ.y + axis.z * bZ.z;
            setAbsolutes(0);
        }

        /**
         * Sets the rotation of b.
         *
         * @param placement its rotation is copied
         * @param rounding is added to the absolute values
         */
        public function setRotation(placement:Placement, rounding:Number = 0):void
        {
            rotation.copyRotation(placement);
            setAbsolutes(rounding);
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
            return rotation.r02 * rotation.r02 + rotation.r12 * rotation.r12 <= Tolerances.PARALLEL;
        }

        private function setAbsolutes(rounding:Number):void
        {
            abs00 = rotation.r00 < 0 ? rounding - rotation.r00 : rounding + rotation.r00;
            abs01 = rotation.r01 < 0 ? rounding - rotation.r01 : rounding + rotation.r01;
            abs02 = rotation.r02 < 0 ? rounding - rotation.r02 : rounding + rotation.r02;
            abs10 = rotation.r10 < 0 ? rounding - rotation.r10 : rounding + rotation.r10;
            abs11 = rotation.r11 < 0 ? rounding - rotation.r11 : rounding + rotation.r11;
            abs12 = rotation.r12 < 0 ? rounding - rotation.r12 : rounding + rotation.r12;
            abs20 = rotation.r20 < 0 ? rounding - rotation.r20 : rounding + rotation.r20;
            abs21 = rotation.r21 < 0 ? rounding - rotation.r21 : rounding + rotation.r21;
            abs22 = rotation.r22 < 0 ? rounding - rotation.r22 : rounding + rotation.r22;
        }
    }
}
