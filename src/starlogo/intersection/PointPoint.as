package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.contactOfSpheres;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.PointSweep;

    /** The kernel of two spheres. When they touch has a closed form: when the centres are as close as both radii. */
    internal final class PointPoint extends PairKernel
    {
        private var _sweep:PointSweep = new PointSweep();

        /** Nothing swept yet. */
        public function PointPoint()
        {
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            _sweep.x = center.x - middle.x + motion.startX;
            _sweep.y = center.y - middle.y + motion.startY;
            _sweep.z = center.z - middle.z + motion.startZ;
            _sweep.reach = sphere.radius + other.radius;
            _sweep.findTime(motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            contactOfSpheres(a as Sphere, b as Sphere, displacement, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            out.aX = center.x;
            out.aY = center.y;
            out.aZ = center.z;
            out.gapX = center.x - middle.x;
            out.gapY = center.y - middle.y;
            out.gapZ = center.z - middle.z;
            out.radiusA = sphere.radius;
            out.radiusB = other.radius;
            out.separate();
        }
    }
}
