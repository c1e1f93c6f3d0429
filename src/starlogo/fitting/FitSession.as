package starlogo.fitting
{
    import flash.utils.Dictionary;
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.ConvexHull;

    /**
     * The vertices of one model while structures are fitted to them: their convex hull, computed once, and what each fitter
     * found, so that a box that a capsule is built from is not searched for twice. Let go of it when the model is done.
     */
    public final class FitSession
    {
        private var _hull:ConvexHull;
        private var _found:Dictionary = new Dictionary();

        /**
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed
         * @throws ArgumentError if they are null or empty, their number of coordinates is no multiple of 3, or one is not
         *         finite
         */
        public function FitSession(vertices:Vector.<Number>)
        {
            _hull = new ConvexHull(vertices);
        }

        /** All vertices, x, y, z each: read only. */
        public function get vertices():Vector.<Number>
        {
            return _hull.vertices;
        }

        /** Their convex hull. */
        public function get hull():ConvexHull
        {
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
            if (fitter == null)
            {
                throw new ArgumentError("the fitter must not be null");
            }
            var found:BoundingStructure = _found[fitter];
            if (found == null)
            {
                found = fitter.fitTo(this);
                _found[fitter] = found;
            }
            return found;
        }
    }
}
