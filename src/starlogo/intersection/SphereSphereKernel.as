package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.findSphereEntry;

    /**
     * The kernel of two spheres.
     *
     * @private
     */
    public final class SphereSphereKernel extends PairKernel
    {
        private var _gap:RoundGap = new RoundGap();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            var gap:RoundGap = _gap;
            gap.x = center.x - middle.x + motion.startX;
            gap.y = center.y - middle.y + motion.startY;
            gap.z = center.z - middle.z + motion.startZ;
            gap.radiusA = sphere.radius;
            gap.radiusB = other.radius;
            findSphereEntry(gap, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            out.x = displacement.startX + center.x;
            out.y = displacement.startY + center.y;
            out.z = displacement.startZ + center.z;
            var x:Number = out.x - middle.x;
            var y:Number = out.y - middle.y;
            var z:Number = out.z - middle.z;
            var squared:Number = x * x + y * y + z * z;
            out.depth = sphere.radius + other.radius;
            // The difference of two points has a direction, however short it is.
            if (squared > 0)
            {
                var length:Number = Math.sqrt(squared);
                out.setNormal(x / length, y / length, z / length);
                out.depth -= length;
            }
            else
            {
                out.setNormal(0, 0, 1);
            }
            _gap.radiusA = sphere.radius;
            placeContact(_gap, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            var gap:RoundGap = _gap;
            gap.x = center.x - middle.x;
            gap.y = center.y - middle.y;
            gap.z = center.z - middle.z;
            gap.radiusA = sphere.radius;
            gap.radiusB = other.radius;
            out.aX = center.x;
            out.aY = center.y;
            out.aZ = center.z;
            moveToSurfaces(gap, out);
        }
    }
}
