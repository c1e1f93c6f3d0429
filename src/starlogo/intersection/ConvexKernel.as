package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConvexContact;
    import starlogo.convex.ConvexMotion;
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /** The kernel of any two structures of which one is a hull, or another convex structure: the convex core decides. */
    internal final class ConvexKernel extends PairKernel
    {
        private var _pair:ConvexPair = new ConvexPair();
        private var _a:ConvexShape = new ConvexShape();
        private var _b:ConvexShape = new ConvexShape();
        private var _motion:ConvexMotion = new ConvexMotion();
        private var _contact:ConvexContact = new ConvexContact();
        private var _closest:ClosestPoints = new ClosestPoints();

        /** @inheritDoc */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var aroundA:BoundingStructure = a.around;
            var aroundB:BoundingStructure = b.around;
            if ((aroundA !== a || aroundB !== b) && !intersects(aroundA, aroundB))
            {
                return false;
            }
            setShapes(a, b);
            return _pair.areTouching(_a, _b);
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            setShapes(a, b);
            setMotion(motion);
            _motion.latest = motion.latest;
            _pair.findTime(_a, _b, _motion);
            motion.time = _motion.time;
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            setShapes(a, b);
            setMotion(displacement);
            _motion.time = 0;
            _pair.findContact(_a, _b, _motion, _contact);
            out.copyConvex(_contact);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
            setShapes(a, b);
            _pair.findClosest(_a, _b, _closest);
            out.copyConvex(_closest);
        }

        private function setShapes(a:BoundingStructure, b:BoundingStructure):void
        {
            _a.setStructure(a);
            _b.setStructure(b);
        }

        private function setMotion(motion:RelativeMotion):void
        {
            _motion.startX = motion.startX;
            _motion.startY = motion.startY;
            _motion.startZ = motion.startZ;
            _motion.x = motion.x;
            _motion.y = motion.y;
            _motion.z = motion.z;
        }
    }
}
