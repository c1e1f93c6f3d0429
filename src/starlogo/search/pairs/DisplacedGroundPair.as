package starlogo.search.pairs
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.penetration.DisplacedPair;

    /** A body and the ground. The body is displaced to find its way out of the ground. */
    internal final class DisplacedGroundPair extends DisplacedPair
    {
        private var _tests:GroundPairTests;

        /** @param tests decide whether the two touch, and when */
        public function DisplacedGroundPair(tests:GroundPairTests)
        {
            _tests = tests;
        }

        /** @inheritDoc */
        override public function areTouching():Boolean
        {
            return _tests.areTouching(first, second);
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            _tests.findImpact(first, second, motion, out);
        }

        /** @inheritDoc */
        override public function findContactOfParts(out:ContactPoint):void
        {
            _tests.findContactOfParts(first, second, RelativeMotion.NONE, out);
        }

        /** @inheritDoc */
        override public function findOuterContact(out:ContactPoint):void
        {
            _tests.findOuterContact(first, second, out);
        }

        /** @inheritDoc */
        override public function findExits(contact:ContactPoint, maxDistance:Number, exits:Vector.<ContactPoint>):int
        {
            return _tests.findExits(first, second, contact, maxDistance, exits);
        }
    }
}
