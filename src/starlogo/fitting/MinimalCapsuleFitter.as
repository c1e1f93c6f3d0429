package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.minimal.CapsuleSearch;

    /**
     * Finds a bounding capsule that is close to the smallest one in any direction (not in the thesis). No practical exact algorithm is
     * known. There is no proof, but the capsule is within 0.1 % of the best capsules that long searches found for the models and point
     * sets of the project's tests.
     *
     * <p>It tries directions all around. For each one, it projects the hull's corners along the direction, puts the capsule's axis
     * through the smallest circle around them, and takes the best of several radii. Then it takes the best capsules and moves their ends
     * as long as the volume shrinks. The smallest sphere is a candidate too. It is a capsule whose ends are one point.</p>
     *
     * <p>The cost in Ruffle is 0.1 seconds for ten corners of the hull, and two to three seconds for 500. While a ModelLoader loads the model,
     * this is some hundred steps.</p>
     */
    public final class MinimalCapsuleFitter extends Fitter
    {
        /** Creates a fitter of capsules that are close to the smallest. */
        public function MinimalCapsuleFitter()
        {
            super("minimal capsule");
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            var search:CapsuleSearch = new CapsuleSearch(session, session.fitOf(new MinimalSphereFitter()));
            return new Fit(session, function(session:FitSession):BoundingStructure
                {
                    return search.best;
                }, search);
        }
    }
}
