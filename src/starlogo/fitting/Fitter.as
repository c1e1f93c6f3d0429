package starlogo.fitting
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;

    /**
     * An algorithm that finds a bounding structure for a model (thesis §3.4): one that encloses every vertex, within 1e-6 of
     * the model's size. That holds for any vertices: one, two, all on a line or in a plane, repeated ones.
     *
     * <p>This is the abstract base of one class per algorithm; a subclass implements <code>fitTo()</code>. Only vertices on
     * the convex hull decide how tight a fit can be (thesis §3.4.2), so the algorithms search with those; a FitSession
     * computes the hull once for all the fitters that are given the same vertices. What they find is then measured in double
     * precision over every vertex.</p>
     */
    public class Fitter
    {
        /** For subclasses only. */
        public function Fitter()
        {
        }

        /**
         * Finds a structure around the vertices. For several fits of the same vertices a FitSession is faster.
         *
         * @param vertices x, y, z of each vertex; not changed
         * @return a structure of its own in the vertices' space and unit
         * @throws ArgumentError if the vertices are null or empty, their number of coordinates is no multiple of 3, or one is
         *         not finite
         */
        public function fit(vertices:Vector.<Number>):BoundingStructure
        {
            return new FitSession(vertices).fit(this);
        }

        /**
         * Finds a structure around the vertices of a session; what other fitters find is at hand there. For a FitSession to
         * call: its <code>fit()</code> remembers the result.
         *
         * @param session the vertices, and their hull
         */
        public function fitTo(session:FitSession):BoundingStructure
        {
            throw new IllegalOperationError(this + " does not implement fitTo");
        }

        /**
         * Begins what <code>fitTo()</code> does, for a game to go on meanwhile: in a single step, unless a subclass overrides
         * this. Those with a search by increments do; the smallest boxes and capsules are found in one go.
         *
         * @param session the vertices, and their hull
         * @return the work, not begun yet
         */
        public function begin(session:FitSession):Fit
        {
            return new Fit(session, this);
        }
    }
}
