package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.sweep.BoxPairMotion;
    import starlogo.intersection.sweep.BoxSweep;

    /** The kernel of two boxes. BoxSweep finds when no axis separates them. The ConvexKernel finds the contact and the distance. */
    internal final class BoxBoxKernel extends PairKernel
    {
        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPairMotion = new BoxPairMotion();
        private var _convex:ConvexKernel;

        // the motion of a box that stands still
        private var _standing:RelativeMotion = new RelativeMotion();

        /** @param convex finds the contact and the distance */
        public function BoxBoxKernel(convex:ConvexKernel)
        {
            _convex = convex;
        }

        /** Whether two boxes touch or overlap, by the sweep's axes. They do not cancel if edges are nearly parallel: see boxBox. */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            findTime(a, b, _standing);
            return _standing.time == 0;
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            setPair(a as Box, b as Box, motion);
            _sweep.findTime(_pair);
            motion.time = _pair.time;
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            _convex.findOverlap(a, b, displacement, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            _convex.findClosest(a, b, out);
        }

        // Sets the pair to two boxes, in the axes of a. While a moves in the structures' space, b moves in the opposite direction as seen from a.
        private function setPair(a:Box, b:Box, motion:RelativeMotion):void
        {
            var pair:BoxPairMotion = _pair;
            var axes:BoxAxes = pair.axes;
            var edgeX:Vector3D = b.axisX;
            var edgeY:Vector3D = b.axisY;
            var edgeZ:Vector3D = b.axisZ;
            var moveX:Number = motion.x;
            var moveY:Number = motion.y;
            var moveZ:Number = motion.z;
            var fromX:Number = b.center.x - a.center.x - motion.startX;
            var fromY:Number = b.center.y - a.center.y - motion.startY;
            var fromZ:Number = b.center.z - a.center.z - motion.startZ;
            var axis:Vector3D = a.axisX;
            axes.xx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            axes.xy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            axes.xz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            pair.motionX = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.x = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisY;
            axes.yx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            axes.yy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            axes.yz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            pair.motionY = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.y = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axis = a.axisZ;
            axes.zx = axis.x * edgeX.x + axis.y * edgeX.y + axis.z * edgeX.z;
            axes.zy = axis.x * edgeY.x + axis.y * edgeY.y + axis.z * edgeY.z;
            axes.zz = axis.x * edgeZ.x + axis.y * edgeZ.y + axis.z * edgeZ.z;
            pair.motionZ = -(axis.x * moveX + axis.y * moveY + axis.z * moveZ);
            pair.z = axis.x * fromX + axis.y * fromY + axis.z * fromZ;
            axes.measureAxes();
            pair.aX = a.halfX;
            pair.aY = a.halfY;
            pair.aZ = a.halfZ;
            pair.bX = b.halfX;
            pair.bY = b.halfY;
            pair.bZ = b.halfZ;
            motion.findMargin();
            pair.tolerance = motion.margin;
        }
    }
}
