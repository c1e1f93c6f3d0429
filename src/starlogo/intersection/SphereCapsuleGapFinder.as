package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a capsule's axis. */
    internal final class SphereCapsuleGapFinder extends GapFinder
    {
        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var time:Number = motion.time;
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var x:Number = center.x - start.x + motion.startX + time * motion.x;
            var y:Number = center.y - start.y + motion.startY + time * motion.y;
            var z:Number = center.z - start.z + motion.startZ + time * motion.z;
            include "../geometry/pointToSegment.inc";
            gap.x = x;
            gap.y = y;
            gap.z = z;
            out.measure(motion);
            gap.pointX = center.x;
            gap.pointY = center.y;
            gap.pointZ = center.z;
            gap.radiusA = sphere.radius;
            gap.radiusB = capsule.radius;
            out.extent = Math.abs(axisX) + Math.abs(axisY) + Math.abs(axisZ) + (sphere.radius + capsule.radius);
        }
    }
}
