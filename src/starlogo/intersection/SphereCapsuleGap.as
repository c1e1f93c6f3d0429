package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a capsule's axis, as seen from the start of the axis. */
    internal final class SphereCapsuleGap extends GapFinder
    {
        private var _sphere:Sphere = null;

        // The vector from the start of the capsule's axis to its end.
        private var _axisX:Number = 0;
        private var _axisY:Number = 0;
        private var _axisZ:Number = 0;

        /** @inheritDoc */
        override public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, way:RelativeMotion, out:CoreGap):void
        {
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            _sphere = sphere;
            _axisX = end.x - start.x;
            _axisY = end.y - start.y;
            _axisZ = end.z - start.z;
            way.startX = center.x - start.x + motion.startX;
            way.startY = center.y - start.y + motion.startY;
            way.startZ = center.z - start.z + motion.startZ;
            way.x = motion.x;
            way.y = motion.y;
            way.z = motion.z;
            out.radiusA = sphere.radius;
            out.radiusB = capsule.radius;
            out.size = Math.abs(_axisX) + Math.abs(_axisY) + Math.abs(_axisZ) + (out.radiusA + out.radiusB);
        }

        /** @inheritDoc */
        override public function find(way:RelativeMotion, out:CoreGap):void
        {
            var time:Number = way.time;
            var x:Number = way.startX + time * way.x;
            var y:Number = way.startY + time * way.y;
            var z:Number = way.startZ + time * way.z;
            var axisX:Number = _axisX;
            var axisY:Number = _axisY;
            var axisZ:Number = _axisZ;
            include "../geometry/pointToSegment.inc";
            out.x = x;
            out.y = y;
            out.z = z;
        }

        /** @inheritDoc */
        override public function finish(out:CoreGap):void
        {
            var center:Vector3D = _sphere.center;
            out.pointX = center.x;
            out.pointY = center.y;
            out.pointZ = center.z;
        }
    }
}
