package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.CoreGap;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * The kernel of two spheres. Their time of impact has a closed form: the path of one centre enters a sphere around the other centre.
     * The radius of that sphere is the sum of both radii.
     *
     * @private
     */
    public final class SphereSphereKernel extends PairKernel
    {
        /** Input of findEntry: the vector from the other centre to this one at time 0. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Input of findEntry: the sum of the radii. */
        public var reach:Number = 0;

        private var _gap:CoreGap = new CoreGap();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            x = center.x - middle.x + motion.startX;
            y = center.y - middle.y + motion.startY;
            z = center.z - middle.z + motion.startZ;
            reach = sphere.radius + other.radius;
            findEntry(motion);
        }

        /**
         * Finds when one centre comes within <code>reach</code> of the other. The fields must be set.
         *
         * @param motion the motion of the one centre; receives the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findEntry(motion:RelativeMotion):void
        {
            var atX:Number = x;
            var atY:Number = y;
            var atZ:Number = z;
            var squared:Number = reach * reach;
            if (atX * atX + atY * atY + atZ * atZ <= squared)
            {
                motion.time = 0;
                return;
            }
            motion.time = RelativeMotion.NEVER;
            var motionX:Number = motion.x;
            var motionY:Number = motion.y;
            var motionZ:Number = motion.z;
            var closing:Number = -(atX * motionX + atY * motionY + atZ * motionZ);
            if (!(closing > 0))
            {
                return;
            }
            // The line enters half a chord before its point that is nearest to the other centre.
            var motionSquared:Number = motionX * motionX + motionY * motionY + motionZ * motionZ;
            var nearest:Number = closing / motionSquared;
            atX += nearest * motionX;
            atY += nearest * motionY;
            atZ += nearest * motionZ;
            var half:Number = squared - (atX * atX + atY * atY + atZ * atZ);
            if (half < 0)
            {
                return;
            }
            var time:Number = nearest - Math.sqrt(half / motionSquared);
            if (time <= 1)
            {
                motion.time = time > 0 ? time : 0;
            }
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
            _gap.radiusA = sphere.radius;
            var gapX:Number = out.x - middle.x;
            var gapY:Number = out.y - middle.y;
            var gapZ:Number = out.z - middle.z;
            out.depth = sphere.radius + other.radius;
            // The difference of two points has a direction, however short it is.
            if (gapX * gapX + gapY * gapY + gapZ * gapZ > 0)
            {
                out.setNormal(gapX, gapY, gapZ);
                out.normalise();
                out.depth -= out.length;
            }
            else
            {
                out.setNormal(0, 0, 1);
            }
            placeContact(_gap, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
            var sphere:Sphere = a as Sphere;
            var other:Sphere = b as Sphere;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = other.center;
            out.aX = center.x;
            out.aY = center.y;
            out.aZ = center.z;
            _gap.x = center.x - middle.x;
            _gap.y = center.y - middle.y;
            _gap.z = center.z - middle.z;
            _gap.radiusA = sphere.radius;
            _gap.radiusB = other.radius;
            moveToSurfaces(_gap, out);
        }
    }
}
