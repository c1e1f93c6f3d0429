package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a box, in the box's axes. */
    internal final class SphereBoxGapFinder extends GapFinder
    {
        /** @inheritDoc */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return sphereBox(a as Sphere, b as Box);
        }

        /** @inheritDoc */
        override public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, coreMotion:CoreMotion, out:CoreGap):void
        {
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var x:Number = center.x - middle.x + motion.startX;
            var y:Number = center.y - middle.y + motion.startY;
            var z:Number = center.z - middle.z + motion.startZ;
            var axis:Vector3D = box.axisX;
            coreMotion.x = axis.x * x + axis.y * y + axis.z * z;
            coreMotion.motionX = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisY;
            coreMotion.y = axis.x * x + axis.y * y + axis.z * z;
            coreMotion.motionY = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisZ;
            coreMotion.z = axis.x * x + axis.y * y + axis.z * z;
            coreMotion.motionZ = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            out.radiusA = sphere.radius;
            out.radiusB = 0;
            out.extent = box.halfX + box.halfY + box.halfZ + out.radiusA;
        }

        /** @inheritDoc */
        override public function findGap(b:BoundingStructure, coreMotion:CoreMotion, out:CoreGap):void
        {
            var time:Number = coreMotion.time;
            PointToBox.measure(coreMotion.x + time * coreMotion.motionX, coreMotion.y + time * coreMotion.motionY, coreMotion.z + time * coreMotion.motionZ,
                    b as Box, out);
        }

        /** @inheritDoc */
        override public function placeGap(a:BoundingStructure, b:BoundingStructure, out:CoreGap):void
        {
            var center:Vector3D = (a as Sphere).center;
            out.pointX = center.x;
            out.pointY = center.y;
            out.pointZ = center.z;
            PointToBox.turn(b as Box, out);
        }
    }
}
