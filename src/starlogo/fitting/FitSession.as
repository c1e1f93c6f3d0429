package starlogo.fitting
{
    import starlogo.engine;
    import starlogo.geometry.ConvexHull;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The vertices of one model while structures are fitted to them. It keeps their convex hull and each fitter's result, so that these are
     * computed once (see <code>Fitter.fitOnce()</code>). Drop the session when the model is finished.
     *
     * <p>The session's steps compute the hull.</p>
     */
    public final class FitSession implements Steps
    {
        private var _hull:ConvexHull;

        // The fits begun for the vertices, and the fitter of each fit.
        private var _fitters:Vector.<Fitter> = new Vector.<Fitter>();
        private var _fits:Vector.<Fit> = new Vector.<Fit>();

        /**
         * Creates a session without fits.
         *
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed
         * @param atOnce false leaves all work, including the check of the vertices, to <code>step()</code>
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if one of them
         *     is not finite or beyond 1e60
         */
        public function FitSession(vertices:Vector.<Number>, atOnce:Boolean = true)
        {
            _hull = new ConvexHull(vertices, atOnce);
        }

        /**
         * @inheritDoc
         * @throws ArgumentError for the constructor's reasons, if it left the check to the steps
         */
        public function step():Boolean
        {
            return _hull.step();
        }

        /** All vertices, x, y, z of each. Read only. */
        public function get vertices():Vector.<Number>
        {
            return _hull.vertices;
        }

        /** The vertices' convex hull. If steps of its computation remain, they are done now. */
        public function get hull():ConvexHull
        {
            finish(_hull);
            return _hull;
        }

        /** @private Returns a fitter's fit for these vertices. The first call makes it, and later calls return the same object. */
        engine function fitOf(fitter:Fitter):Fit
        {
            var i:int = _fitters.indexOf(fitter);
            if (i >= 0)
            {
                return _fits[i];
            }
            var fit:Fit = fitter.fitting(this);
            _fitters.push(fitter);
            _fits.push(fit);
            return fit;
        }
    }
}
