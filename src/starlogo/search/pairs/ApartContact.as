package starlogo.search.pairs
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;

    /**
     * Finds the contact of two bodies that do not touch, from their closest points. Spheres alone need no such object, so a game of spheres loads none
     * of this.
     *
     * @private
     */
    public final class ApartContact
    {
        private var _closest:ClosestPoints = new ClosestPoints();

        /** Changes a contact of parts as <code>PairTests.separateApart()</code> says. */
        public function find(tests:PairTests, a:Body, b:Body, out:ContactPoint):void
        {
            if (NarrowPhase.isReversed(a, b))
            {
                tests.findClosest(b, a, false, _closest);
                _closest.swap();
            }
            else
            {
                tests.findClosest(a, b, false, _closest);
            }
            _closest.writeContact(out);
        }
    }
}
