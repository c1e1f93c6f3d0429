package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.pointPointImpact;

    /** The kernel of two spheres. When they touch has a closed form: when the centres are as close as both radii. */
    internal final class PointPoint extends ClosestPoints
    {
        /** Nothing related yet. */
        public function PointPoint()
        {
        }

        /** @inheritDoc */
        override public function timeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):Number
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            return pointPointImpact(center.x - middle.x + motion.startX, center.y - middle.y + motion.startY,
                    center.z - middle.z + motion.startZ, motion.x, motion.y, motion.z, sphere.radius + other.radius);
        }

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            gapX = center.x - middle.x + motion.startX;
            gapY = center.y - middle.y + motion.startY;
            gapZ = center.z - middle.z + motion.startZ;
            radii = sphere.radius + other.radius;
        }

        // Asked at time 0 only, where relate has left the gap.
        override protected function find(time:Number):void
        {
        }

        // The difference of two points has a direction however short it is.
        override protected function get size():Number
        {
            return 0;
        }

        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            out.pointAlong(0, 0, 1);
            placeContact(a, displacement, radii, out);
        }
    }
}
