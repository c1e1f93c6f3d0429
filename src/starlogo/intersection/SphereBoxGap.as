package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a box, in the box's axes. */
    internal final class SphereBoxGap extends GapFinder
    {
        /** @inheritDoc */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return sphereBox(a as Sphere, b as Box);
        }

        /** @inheritDoc */
        override public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, localMotion:RelativeMotion, out:CoreGap):void
        {
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var x:Number = center.x - middle.x + motion.startX;
            var y:Number = center.y - middle.y + motion.startY;
            var z:Number = center.z - middle.z + motion.startZ;
            var axis:Vector3D = box.axisX;
            localMotion.startX = axis.x * x + axis.y * y + axis.z * z;
            localMotion.x = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisY;
            localMotion.startY = axis.x * x + axis.y * y + axis.z * z;
            localMotion.y = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisZ;
            localMotion.startZ = axis.x * x + axis.y * y + axis.z * z;
            localMotion.z = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            out.radiusA = sphere.radius;
            out.radiusB = 0;
            out.extent = box.halfX + box.halfY + box.halfZ + out.radiusA;
        }

        /** @inheritDoc */
        override public function find(b:BoundingStructure, localMotion:RelativeMotion, out:CoreGap):void
        {
            var time:Number = localMotion.time;
            BoxGap.measure(localMotion.startX + time * localMotion.x, localMotion.startY + time * localMotion.y, localMotion.startZ + time * localMotion.z,
                    b as Box, out);
        }

        /** @inheritDoc */
        override public function finish(a:BoundingStructure, b:BoundingStructure, out:CoreGap):void
        {
            var center:Vector3D = (a as Sphere).center;
            out.pointX = center.x;
            out.pointY = center.y;
            out.pointZ = center.z;
            BoxGap.turn(b as Box, out);
        }
    }
}
