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
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Two boxes, as a record: box b as seen from box a. All vectors are three numbers in the axes of a. All pairs of boxes of two trees have the same
     * rotation, motion and margin. Then these are set once for all of them.
     *
     * @private
     */
    public final class BoxPair
    {
        /** The pair that <code>boxBox()</code> sets, and BoxSweep for it. */
        public static const SCRATCH:BoxPair = new BoxPair();

        /** The rotation of b, row by row: its columns are the axes of b. Nine numbers. */
        public var rotation:Vector.<Number> = new Vector.<Number>(9, true);

        /** The absolute values of the rotation. */
        public var absolutes:Vector.<Number> = new Vector.<Number>(9, true);

        /** The vector from a's middle to b's, at time 0 if b moves. boxBox() shortens it in place of a margin. */
        public var offset:Vector.<Number> = new Vector.<Number>(3, true);

        /** The half-extents of a, and those of b along its own axes. */
        public var halvesA:Vector.<Number> = new Vector.<Number>(3, true);
        public var halvesB:Vector.<Number> = new Vector.<Number>(3, true);

        /** The vector that b moves by until time 1. Only BoxSweep reads it. */
        public var motion:Vector.<Number> = new Vector.<Number>(3, true);

        /** The gap across which the boxes still touch: the sum of the margins (see Touching). Only BoxSweep reads it. */
        public var margin:Number = 0;

        /** Sets all from two boxes. @param motion the motion of a */
        public function setMoving(a:Box, b:Box, motion:RelativeMotion):void
        {
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            offset[0] = a.axisX.x * fromX + a.axisX.y * fromY + a.axisX.z * fromZ;
            offset[1] = a.axisY.x * fromX + a.axisY.y * fromY + a.axisY.z * fromZ;
            offset[2] = a.axisZ.x * fromX + a.axisZ.y * fromY + a.axisZ.z * fromZ;
            // while a moves, b moves in the opposite direction as seen from a
            this.motion[0] = -(a.axisX.x * motion.x + a.axisX.y * motion.y + a.axisX.z * motion.z);
            this.motion[1] = -(a.axisY.x * motion.x + a.axisY.y * motion.y + a.axisY.z * motion.z);
            this.motion[2] = -(a.axisZ.x * motion.x + a.axisZ.y * motion.y + a.axisZ.z * motion.z);
            margin = motion.margin;
            setBoxes(a, b);
        }

        /** Sets the rotation and the half-extents. */
        public function setBoxes(a:Box, b:Box):void
        {
            halvesA[0] = a.halfX;
            halvesA[1] = a.halfY;
            halvesA[2] = a.halfZ;
            halvesB[0] = b.halfX;
            halvesB[1] = b.halfY;
            halvesB[2] = b.halfZ;
            setRow(0, a.axisX, b);
            setRow(3, a.axisY, b);
            setRow(6, a.axisZ, b);
            setAbsolutes(0);
        }

        // Sets a row of the rotation, from an index on: the components of b's axes along an axis of a.
        private function setRow(at:int, axis:Vector3D, b:Box):void
        {
            rotation[at] = axis.x * b.axisX.x + axis.y * b.axisX.y + axis.z * b.axisX.z;
            rotation[int(at + 1)] = axis.x * b.axisY.x + axis.y * b.axisY.y + axis.z * b.axisY.z;
            rotation[int(at + 2)] = axis.x * b.axisZ.x + axis.y * b.axisZ.y + axis.z * b.axisZ.z;
        }

        /**
         * Sets the rotation of b.
         *
         * @param placement its rotation is copied
         * @param rounding is added to the absolute values
         */
        public function setRotation(placement:Placement, rounding:Number = 0):void
        {
            placement.readRows(rotation, 0);
            setAbsolutes(rounding);
        }

        private function setAbsolutes(rounding:Number):void
        {
            for (var i:int = 0; i < 9; i++)
            {
                absolutes[i] = rotation[i] < 0 ? rounding - rotation[i] : rounding + rotation[i];
            }
        }

        /** Whether edges of the two boxes are so nearly parallel that their cross product would cancel. */
        public function get areNearlyParallel():Boolean
        {
            var near:Number = 1 - Tolerances.NEARLY_PARALLEL / 2;
            for (var i:int = 0; i < 9; i++)
            {
                if (absolutes[i] > near)
                {
                    return true;
                }
            }
            return false;
        }

        /** Whether the z axes of the two boxes are parallel. Then their faces are enough: the cross products of other edges are along z or across it. */
        public function get areZAxesParallel():Boolean
        {
            return rotation[2] * rotation[2] + rotation[5] * rotation[5] <= Tolerances.PARALLEL;
        }
    }
}
