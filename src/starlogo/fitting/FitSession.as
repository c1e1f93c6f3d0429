package starlogo.fitting
{
    import starlogo.engine;
    import starlogo.geometry.ConvexHull;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The vertices of one model while structures are fitted to them: their convex hull, computed once, and what each fitter
     * does or has done for them (see <code>Fitter.fitOnce()</code>). To be dropped when the model is done.
     *
     * <p>The hull may be computed in steps, which are those of the session.</p>
     */
    public final class FitSession implements Steps
    {
        private var _hull:ConvexHull;

        // The fits begun for the vertices, and the fitter of each.
        private var _fitters:Vector.<Fitter> = new Vector.<Fitter>();
        private var _fits:Vector.<Fit> = new Vector.<Fit>();

        /**
         * A session without fits.
         *
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed
         * @param atOnce false leaves all work, including the check of the vertices, to <code>step()</code>
         * @throws ArgumentError if they are null or empty, their number of coordinates is no multiple of 3, or one is not
         *         finite
         */
        public function FitSession(vertices:Vector.<Number>, atOnce:Boolean = true)
        {
            _hull = new ConvexHull(vertices, atOnce);
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError what the constructor throws, if it left the check to the steps
         */
        public function step():Boolean
        {
            return _hull.step();
        }

        /** All vertices, x, y, z each: read only. */
        public function get vertices():Vector.<Number>
        {
            return _hull.vertices;
        }

        /** Their convex hull; steps that are left of its computation are done now. */
        public function get hull():ConvexHull
        {
            finish(_hull);
            return _hull;
        }

        /** @private The fit of a fitter for these vertices: begun at the first call, and the same object at every other. */
        engine function fitOf(fitter:Fitter):Fit
        {
            var i:int = _fitters.indexOf(fitter);
            if (i >= 0)
            {
                return _fits[i];
            }
            var fit:Fit = fitter.begin(this);
            _fitters.push(fitter);
            _fits.push(fit);
            return fit;
        }
    }
}
