package starlogo.search.pairs
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.penetration.DisplacedPair;

    /** A pair with a tree, whose first body is displaced to find its way out of the second one. */
    internal final class DisplacedTreePair extends DisplacedPair
    {
        private var _tests:TreePairTests;
        private var _stopsAtLeaves:Boolean;

        /**
         * @param tests decide whether the bodies touch, and when
         * @param stopsAtLeaves whether the leaves of trees decide, even if there are triangles
         */
        public function DisplacedTreePair(tests:TreePairTests, stopsAtLeaves:Boolean)
        {
            _tests = tests;
            _stopsAtLeaves = stopsAtLeaves;
        }

        /** @inheritDoc */
        override public function get haveTriangles():Boolean
        {
            return _tests.limits.exact;
        }

        /** @inheritDoc */
        override public function areTouching():Boolean
        {
            return _stopsAtLeaves ? _tests.areLeavesTouching(first, second) : _tests.areTouching(first, second);
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            if (_stopsAtLeaves)
            {
                _tests.findImpactOfLeaves(first, second, motion, out);
                return;
            }
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
    }
}
