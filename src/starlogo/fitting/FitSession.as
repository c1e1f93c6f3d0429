package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.steps.finish;
    import starlogo.steps.Steps;

    /**
     * The vertices of one model while structures are fitted to them. It keeps their convex hull and each fitter's result, so that these are
     * computed once. Drop the session when the model is finished.
     *
     * <p>The session's steps compute the hull.</p>
     */
    public final class FitSession implements Steps
    {
        private var _hull:ConvexHull;

        // The fits begun for the vertices, and the signature of the fitter of each, or the fitter if it has none.
        private var _keys:Array = [];
        private var _fits:Vector.<Fit> = new Vector.<Fit>();

        /**
         * Creates a session without fits.
         *
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed. The steps check them, and refuse null
         */
        public function FitSession(vertices:Vector.<Number>)
        {
            _hull = new ConvexHull(vertices, false);
        }

        /**
         * @inheritDoc
         * @throws ArgumentError if the vertices are null or empty, if the number of coordinates is not a multiple of 3, or if one of them
         *     is not finite or beyond 1e60
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

        /** The vertices' convex hull. If steps of its computation remain, they are done now. @throws ArgumentError as step() */
        public function get hull():ConvexHull
        {
            finish(_hull);
            return _hull;
        }

        /**
         * The work of a fitter on the vertices. The first call makes it, and later calls return the same object, also for another fitter with the
         * same signature. So if several capsules are built from one box, the box is found once.
         */
        public function fitOf(fitter:Fitter):Fit
        {
            var key:Object = fitter.signature || fitter;
            var i:int = _keys.indexOf(key);
            if (i >= 0)
            {
                return _fits[i];
            }
            var fit:Fit = fitter.fitting(this);
            _keys.push(key);
            _fits.push(fit);
            return fit;
        }

        /** The structure that a fitter finds around the vertices, as <code>fitOf()</code>. If steps of its work remain, they are done now. */
        public function structureOf(fitter:Fitter):BoundingStructure
        {
            var fit:Fit = fitOf(fitter);
            finish(fit);
            return fit.structure;
        }
    }
}
