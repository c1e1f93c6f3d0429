package starlogo.search.pairs
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;

    /** The tests for a way out of pairs with a tree, as if the leaves of trees decided, even if there are triangles. */
    internal final class LeafPairTests extends PairTests
    {
        private var _tests:TreePairTests;

        /** @param tests makes them, and counts them */
        public function LeafPairTests(tests:TreePairTests)
        {
            _tests = tests;
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            return _tests.areOverlapping(a, b, false);
        }

        /** @inheritDoc */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _tests.findTreeContact(a, b, motion, false, out);
        }

        /** @inheritDoc */
        override public function findImpact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _tests.findTreeImpact(a, b, motion, false, out);
        }
    }
}
