package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a sphere's centre and a capsule's axis, as seen from the start of the axis. */
    internal final class SphereCapsuleGapFinder extends GapFinder
    {
        // The vector from the start of the capsule's axis to its end.
        private var _axisX:Number = 0;
        private var _axisY:Number = 0;
        private var _axisZ:Number = 0;

        /** @inheritDoc */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return sphereCapsule(a as Sphere, b as Capsule);
        }

        /** @inheritDoc */
        override public function begin(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, coreMotion:CoreMotion, out:CoreGap):void
        {
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            _axisX = end.x - start.x;
            _axisY = end.y - start.y;
            _axisZ = end.z - start.z;
            coreMotion.x = center.x - start.x + motion.startX;
            coreMotion.y = center.y - start.y + motion.startY;
            coreMotion.z = center.z - start.z + motion.startZ;
            coreMotion.motionX = motion.x;
            coreMotion.motionY = motion.y;
            coreMotion.motionZ = motion.z;
            out.radiusA = sphere.radius;
            out.radiusB = capsule.radius;
            out.extent = Math.abs(_axisX) + Math.abs(_axisY) + Math.abs(_axisZ) + (out.radiusA + out.radiusB);
        }

        /** @inheritDoc */
        override public function findGap(b:BoundingStructure, coreMotion:CoreMotion, out:CoreGap):void
        {
            var time:Number = coreMotion.time;
            var x:Number = coreMotion.x + time * coreMotion.motionX;
            var y:Number = coreMotion.y + time * coreMotion.motionY;
            var z:Number = coreMotion.z + time * coreMotion.motionZ;
            var axisX:Number = _axisX;
            var axisY:Number = _axisY;
            var axisZ:Number = _axisZ;
            include "../geometry/pointToSegment.inc";
            out.x = x;
            out.y = y;
            out.z = z;
        }

        /** @inheritDoc */
        override public function placeGap(a:BoundingStructure, b:BoundingStructure, out:CoreGap):void
        {
            var center:Vector3D = (a as Sphere).center;
            out.pointX = center.x;
            out.pointY = center.y;
            out.pointZ = center.z;
        }
    }
}
