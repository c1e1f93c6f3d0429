package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of a capsule and a box. It works in the box's axes, mirrored so that no component of the capsule's axis is negative. */
    internal class CapsuleBoxKernel extends SphereBoxKernel
    {
        private static const OVERLAP_KERNEL:BoxBoxKernel = new BoxBoxKernel();

        /** The vector from the segment's start to its end, in these axes. Not negative. */
        protected var alongX:Number;
        protected var alongY:Number;
        protected var alongZ:Number;

        // -1 if the box's axis is mirrored, otherwise 1.
        private var _signX:Number = 1;
        private var _signY:Number = 1;
        private var _signZ:Number = 1;

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var middle:Vector3D = box.center;
            var x:Number = start.x - middle.x;
            var y:Number = start.y - middle.y;
            var z:Number = start.z - middle.z;
            var toX:Number = end.x - start.x;
            var toY:Number = end.y - start.y;
            var toZ:Number = end.z - start.z;
            var axis:Vector3D = box.axisX;
            var along:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            var sign:Number = along < 0 ? -1 : 1;
            alongX = sign * along;
            fromX = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            motionX = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _signX = sign;
            axis = box.axisY;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            sign = along < 0 ? -1 : 1;
            alongY = sign * along;
            fromY = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            motionY = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _signY = sign;
            axis = box.axisZ;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            sign = along < 0 ? -1 : 1;
            alongZ = sign * along;
            fromZ = sign * (axis.x * x + axis.y * y + axis.z * z + (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ));
            motionZ = sign * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            _signZ = sign;
            halfX = box.halfX;
            halfY = box.halfY;
            halfZ = box.halfZ;
            radiusSum = capsule.radius;
        }

        override protected function find():void
        {
            var time:Number = timeParameter;
            var px:Number = fromX + time * motionX;
            var py:Number = fromY + time * motionY;
            var pz:Number = fromZ + time * motionZ;
            var halfX:Number = this.halfX;
            var halfY:Number = this.halfY;
            var halfZ:Number = this.halfZ;
            var dx:Number = alongX;
            var dy:Number = alongY;
            var dz:Number = alongZ;
            include "segmentToBox.inc";
            if (lastIn <= firstOut)
            {
                // If several points are nearest, take the one in the middle of them.
                lastIn = lastIn > 0 ? (lastIn < 1 ? lastIn : 1) : 0;
                firstOut = firstOut > 0 ? (firstOut < 1 ? firstOut : 1) : 0;
                t = (lastIn + firstOut) / 2;
            }
            // The comparison is false for NaN too.
            t = t > 0 ? (t < 1 ? t : 1) : 0;
            share = t;
            var x:Number = px + t * dx;
            var y:Number = py + t * dy;
            var z:Number = pz + t * dz;
            include "pointToBox.inc";
            gapX = x;
            gapY = y;
            gapZ = z;
        }

        override protected function measure():void
        {
            size = alongX + alongY + alongZ + halfX + halfY + halfZ + radiusSum;
        }

        override protected function rotateGap(b:BoundingStructure):void
        {
            gapX *= _signX;
            gapY *= _signY;
            gapZ *= _signZ;
            super.rotateGap(b);
        }

        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            OVERLAP_KERNEL.findContact(a, b, displacement, out);
        }
    }
}
