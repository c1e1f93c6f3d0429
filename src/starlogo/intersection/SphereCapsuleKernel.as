package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.NewtonSteps;

    /** The kernel of a sphere and a capsule. */
    internal final class SphereCapsuleKernel extends PairKernel
    {
        // The motion of the sphere's centre as seen from the start of the capsule's axis.
        private var _way:RelativeMotion = new RelativeMotion();
        private var _gap:RoundGap = new RoundGap();
        private var _steps:NewtonSteps = new NewtonSteps();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var capsule:Capsule = b as Capsule;
            relate(a as Sphere, capsule, motion);
            findGap(capsule);
            if (_steps.begin(motion, _way, _gap))
            {
                var start:Vector3D = capsule.start;
                var end:Vector3D = capsule.end;
                var x:Number = end.x - start.x;
                var y:Number = end.y - start.y;
                var z:Number = end.z - start.z;
                _gap.size = Math.sqrt(x * x + y * y + z * z) + (_gap.radiusA + _gap.radiusB);
                do
                {
                    findGap(capsule);
                }
                while (_steps.next(_way, _gap));
            }
            motion.time = _way.time;
        }

        /**
         * A sphere's contact is written out here, because calls of relate() and findGap() are slow in Adobe's VM.
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
            var squared:Number = x * x + y * y + z * z;
            var least:Number = Tolerances.DIRECTION * (Math.sqrt(lengthSquared) + depth);
            if (squared > least * least)
            {
                var length:Number = Math.sqrt(squared);
                out.setNormal(x / length, y / length, z / length);
                depth -= length;
            }
            else
            {
                out.setNormal(axisX, axisY, axisZ);
                out.makePerpendicular();
            }
            out.depth = depth;
            _gap.radiusA = sphere.radius;
            placeContact(_gap, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            relate(sphere, capsule, RelativeMotion.NONE);
            findGap(capsule);
            var center:Vector3D = sphere.center;
            out.aX = center.x;
            out.aY = center.y;
            out.aZ = center.z;
            moveToSurfaces(_gap, out);
        }

        // Sets the way at time 0, and the radii.
        private function relate(sphere:Sphere, capsule:Capsule, motion:RelativeMotion):void
        {
            var way:RelativeMotion = _way;
            var center:Vector3D = sphere.center;
            var start:Vector3D = capsule.start;
            way.startX = center.x - start.x + motion.startX;
            way.startY = center.y - start.y + motion.startY;
            way.startZ = center.z - start.z + motion.startZ;
            way.x = motion.x;
            way.y = motion.y;
            way.z = motion.z;
            way.time = 0;
            _gap.radiusA = sphere.radius;
            _gap.radiusB = capsule.radius;
        }

        // Finds the gap at the way's time.
        private function findGap(capsule:Capsule):void
        {
            var way:RelativeMotion = _way;
            var time:Number = way.time;
            var x:Number = way.startX + time * way.x;
            var y:Number = way.startY + time * way.y;
            var z:Number = way.startZ + time * way.z;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            include "../geometry/pointToSegment.inc";
            var gap:RoundGap = _gap;
            gap.x = x;
            gap.y = y;
            gap.z = z;
        }
    }
}
