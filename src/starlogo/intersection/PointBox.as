package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of a sphere and a box, in the box's axes; SegmentBox puts a capsule in the sphere's place. */
    internal class PointBox extends ClosestPoints
    {
        /** The box's half-extents. */
        protected var halfX:Number;

        /** @copy #halfX */
        protected var halfY:Number;

        /** @copy #halfX */
        protected var halfZ:Number;

        /** Nothing related yet. */
        public function PointBox()
        {
        }

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var x:Number = center.x - middle.x + motion.startX;
            var y:Number = center.y - middle.y + motion.startY;
            var z:Number = center.z - middle.z + motion.startZ;
            var axis:Vector3D = box.axisX;
            fromX = axis.x * x + axis.y * y + axis.z * z;
            motionX = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisY;
            fromY = axis.x * x + axis.y * y + axis.z * z;
            motionY = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisZ;
            fromZ = axis.x * x + axis.y * y + axis.z * z;
            motionZ = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            halfX = box.halfX;
            halfY = box.halfY;
            halfZ = box.halfZ;
            radii = sphere.radius;
        }

        override protected function find(time:Number):void
        {
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            var half:Number = halfX;
            x = x > half ? x - half : (x < -half ? x + half : 0);
            half = halfY;
            y = y > half ? y - half : (y < -half ? y + half : 0);
            half = halfZ;
            z = z > half ? z - half : (z < -half ? z + half : 0);
            gapX = x;
            gapY = y;
            gapZ = z;
        }

        override protected function get size():Number
        {
            return halfX + halfY + halfZ + radii;
        }

        override protected function pointAlongGap(b:BoundingStructure, out:ContactPoint):void
        {
            var box:Box = b as Box;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            out.pointAlong(gapX * axisX.x + gapY * axisY.x + gapZ * axisZ.x, gapX * axisX.y + gapY * axisY.y + gapZ * axisZ.y,
                    gapX * axisX.z + gapY * axisY.z + gapZ * axisZ.z);
        }

        // Out through the nearest face.
        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var box:Box = b as Box;
            var axis:Vector3D = box.axisX;
            var along:Number = fromX;
            var depth:Number = halfX - Math.abs(fromX);
            if (halfY - Math.abs(fromY) < depth)
            {
                axis = box.axisY;
                along = fromY;
                depth = halfY - Math.abs(fromY);
            }
            if (halfZ - Math.abs(fromZ) < depth)
            {
                axis = box.axisZ;
                along = fromZ;
                depth = halfZ - Math.abs(fromZ);
            }
            var side:Number = along < 0 ? -1 : 1;
            out.pointAlong(side * axis.x, side * axis.y, side * axis.z);
            placeContact(a, displacement, radii + depth, out);
        }
    }
}
