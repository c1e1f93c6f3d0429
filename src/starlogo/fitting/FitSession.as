package starlogo.fitting
{
    import flash.utils.Dictionary;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.ConvexHull;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The vertices of one model while structures are fitted to them: their convex hull, computed once, and what each fitter
     * found, so that a box that a capsule is built from is not searched for twice. Let go of it when the model is done.
     *
     * <p>The hull may be computed in steps, which are those of the session.</p>
     */
    public final class FitSession implements Steps
    {
        private var _hull:ConvexHull;
        private var _found:Dictionary = new Dictionary();

        /**
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed
         * @param atOnce false leaves the hull to <code>step()</code>
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
         * @throws ArgumentError if a coordinate is not finite
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

        /** Their convex hull; what steps have left of it is done now. */
        public function get hull():ConvexHull
        {
            var hasMore:Boolean = true;
            while (hasMore)
            {
                hasMore = _hull.step();
            }
            return _hull;
        }

        /**
         * What a fitter finds for these vertices; the same object whenever it is asked again.
         *
         * @param fitter any fitter
         * @throws ArgumentError if it is null
         */
        public function fit(fitter:Fitter):BoundingStructure
        {
            check(fitter);
            var found:BoundingStructure = _found[fitter];
            if (found == null)
            {
                found = fitter.fitTo(this);
                _found[fitter] = found;
            }
            return found;
        }

        /**
         * Begins what <code>fit()</code> does: after the last step it is at hand there.
         *
         * @param fitter any fitter
         * @throws ArgumentError if it is null
         */
        public function begin(fitter:Fitter):Fit
        {
            check(fitter);
            return fitter.begin(this);
        }

        /** Whether it is known what a fitter finds. */
        engine function hasFitted(fitter:Fitter):Boolean
        {
            return _found[fitter] != null;
        }

        /** Takes what a fitter has found. */
        engine function keep(fitter:Fitter, structure:BoundingStructure):void
        {
            _found[fitter] = structure;
        }

        private static function check(fitter:Fitter):void
        {
            if (fitter == null)
            {
                throw new ArgumentError("the fitter must not be null");
            }
        }
    }
}
