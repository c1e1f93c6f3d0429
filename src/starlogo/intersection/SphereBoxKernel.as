package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of a sphere and a box. It works in the box's axes. CapsuleBoxKernel extends it for capsules. */
    internal class SphereBoxKernel extends RoundPairKernel
    {
        /** The box's half-extents. */
        protected var halfX:Number;
        protected var halfY:Number;
        protected var halfZ:Number;

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
            radiusSum = sphere.radius;
        }

        override protected function find():void
        {
            var time:Number = timeParameter;
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            include "pointToBox.inc";
            gapX = x;
            gapY = y;
            gapZ = z;
        }

        override protected function measure():void
        {
            size = halfX + halfY + halfZ + radiusSum;
        }

        /**
         * A sphere's contact is written out here, because relate() and find() take 1.5 times as long in Adobe's VM.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var sphere:Sphere = a as Sphere;
            if (sphere == null)
            {
                super.findContact(a, b, displacement, out);
                return;
            }
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            out.x = displacement.startX + center.x;
            out.y = displacement.startY + center.y;
            out.z = displacement.startZ + center.z;
            var toX:Number = out.x - middle.x;
            var toY:Number = out.y - middle.y;
            var toZ:Number = out.z - middle.z;
            var x:Number = axisX.x * toX + axisX.y * toY + axisX.z * toZ;
            var y:Number = axisY.x * toX + axisY.y * toY + axisY.z * toZ;
            var z:Number = axisZ.x * toX + axisZ.y * toY + axisZ.z * toZ;
            gapX = x;
            gapY = y;
            gapZ = z;
            halfX = box.halfX;
            halfY = box.halfY;
            halfZ = box.halfZ;
            include "pointToBox.inc";
            var radius:Number = sphere.radius;
            gap.radiusA = radius;
            var squared:Number = x * x + y * y + z * z;
            var least:Number = Tolerances.DIRECTION * (halfX + halfY + halfZ + radius);
            if (squared > least * least)
            {
                out.setNormal(x * axisX.x + y * axisY.x + z * axisZ.x, x * axisX.y + y * axisY.y + z * axisZ.y,
                        x * axisX.z + y * axisY.z + z * axisZ.z);
                out.normalise();
                out.depth = radius - Math.sqrt(squared);
            }
            else
            {
                pointThroughFace(box, out);
                out.depth += radius;
            }
            placeContact(gap, out);
        }

        override protected function rotateGap(b:BoundingStructure):void
        {
            var box:Box = b as Box;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            var x:Number = gapX;
            var y:Number = gapY;
            var z:Number = gapZ;
            gapX = x * axisX.x + y * axisY.x + z * axisZ.x;
            gapY = x * axisX.y + y * axisY.y + z * axisZ.y;
            gapZ = x * axisX.z + y * axisY.z + z * axisZ.z;
        }

        // Points a contact's normal from the gap's place out through the nearest face. The depth is the distance to that face.
        private function pointThroughFace(box:Box, out:ContactPoint):void
        {
            var x:Number = gapX;
            var y:Number = gapY;
            var z:Number = gapZ;
            var axis:Vector3D = box.axisX;
            var along:Number = x;
            var depth:Number = halfX - Math.abs(x);
            if (halfY - Math.abs(y) < depth)
            {
                axis = box.axisY;
                along = y;
                depth = halfY - Math.abs(y);
            }
            if (halfZ - Math.abs(z) < depth)
            {
                axis = box.axisZ;
                along = z;
                depth = halfZ - Math.abs(z);
            }
            var side:Number = along < 0 ? -1 : 1;
            out.setNormal(side * axis.x, side * axis.y, side * axis.z);
            out.normalise();
            out.depth = depth;
        }
    }
}
