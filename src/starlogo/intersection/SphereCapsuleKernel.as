package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of a sphere and a capsule. */
    internal final class SphereCapsuleKernel extends RoundPairKernel
    {
        private var _axisX:Number;
        private var _axisY:Number;
        private var _axisZ:Number;

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            _axisX = end.x - start.x;
            _axisY = end.y - start.y;
            _axisZ = end.z - start.z;
            fromX = center.x - start.x + motion.startX;
            fromY = center.y - start.y + motion.startY;
            fromZ = center.z - start.z + motion.startZ;
            motionX = motion.x;
            motionY = motion.y;
            motionZ = motion.z;
            radiusSum = sphere.radius + capsule.radius;
        }

        override protected function find():void
        {
            var time:Number = timeParameter;
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            var axisX:Number = _axisX;
            var axisY:Number = _axisY;
            var axisZ:Number = _axisZ;
            include "../geometry/pointToSegment.inc";
            gapX = x;
            gapY = y;
            gapZ = z;
        }

        override protected function measure():void
        {
            size = Math.sqrt(_axisX * _axisX + _axisY * _axisY + _axisZ * _axisZ) + radiusSum;
        }

        /**
         * A sphere's contact is written out here, because relate() and find() take 1.5 times as long in Adobe's VM.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            out.x = displacement.startX + center.x;
            out.y = displacement.startY + center.y;
            out.z = displacement.startZ + center.z;
            var x:Number = out.x - start.x;
            var y:Number = out.y - start.y;
            var z:Number = out.z - start.z;
            include "../geometry/pointToSegment.inc";
            var depth:Number = sphere.radius + capsule.radius;
            gap.radiusA = sphere.radius;
            out.depth = depth;
            var least:Number = Tolerances.DIRECTION * (Math.sqrt(lengthSquared) + depth);
            if (x * x + y * y + z * z > least * least)
            {
                out.setNormal(x, y, z);
                out.normalise();
                out.depth -= out.length;
            }
            else
            {
                out.setNormal(axisX, axisY, axisZ);
                out.makePerpendicular();
            }
            placeContact(gap, out);
        }
    }
}
