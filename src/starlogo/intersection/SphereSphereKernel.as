package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.findTimeOfImpactOfSpheres;

    /**
     * The kernel of two spheres.
     *
     * @private
     */
    public final class SphereSphereKernel extends StructurePairKernel
    {
        private var _gap:CoreGap = new CoreGap();

        /** @inheritDoc */
        override internal function findTimeOfImpactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion):void
        {
            motion.time = 0;
            setGap(first as Sphere, second as Sphere, motion);
            findTimeOfImpactOfSpheres(_gap, motion);
        }

        /** @inheritDoc */
        override internal function findContactInOrder(first:BoundingStructure, second:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            setGap(first as Sphere, second as Sphere, motion);
            out.setFromGap(_gap, motion);
        }

        /** @inheritDoc */
        override internal function findClosestInOrder(first:BoundingStructure, second:BoundingStructure, out:ClosestPoints):void
        {
            setGap(first as Sphere, second as Sphere, RelativeMotion.NONE);
            out.setFromGap(_gap);
        }

        // Sets the gap at the motion's time.
        private function setGap(a:Sphere, b:Sphere, motion:RelativeMotion):void
        {
            var gap:CoreGap = _gap;
            var center:Vector3D = a.center;
            var other:Vector3D = b.center;
            gap.point.copyFrom(center);
            gap.x = center.x - other.x + motion.startX + motion.time * motion.x;
            gap.y = center.y - other.y + motion.startY + motion.time * motion.y;
            gap.z = center.z - other.z + motion.startZ + motion.time * motion.z;
            gap.radiusA = a.radius;
            gap.radiusB = b.radius;
        }
    }
}
