package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a box. */
    internal final class SphereBoxGapFinder extends GapFinder
    {
        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var x:Number = center.x - middle.x + motion.startX;
            var y:Number = center.y - middle.y + motion.startY;
            var z:Number = center.z - middle.z + motion.startZ;
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            gap.x = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisY;
            gap.y = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            axis = box.axisZ;
            gap.z = axis.x * x + axis.y * y + axis.z * z + time * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z);
            out.measureToBox(box, motion);
            gap.pointX = center.x;
            gap.pointY = center.y;
            gap.pointZ = center.z;
            gap.radiusA = sphere.radius;
            gap.radiusB = 0;
            out.extent = box.halfX + box.halfY + box.halfZ + sphere.radius;
        }
    }
}
