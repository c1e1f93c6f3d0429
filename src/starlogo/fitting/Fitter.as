package starlogo.fitting
{
    import flash.errors.IllegalOperationError;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * An algorithm that finds a bounding structure for a model (thesis §3.4): one that encloses every vertex, within 1e-6 of
     * the model's size. That holds for any vertices: one, two, all on a line or in a plane, repeated ones.
     *
     * <p>This is the abstract base of one class per algorithm; a subclass implements <code>findStructure()</code>, or, to work in
     * steps, <code>begin()</code>, and nothing else. Only vertices on the convex hull decide how tight a fit can be (thesis §3.4.2), so the algorithms search with those; a FitSession
     * computes the hull once for all the fitters that are given the same vertices. The structures are then measured in double precision over every
     * vertex.</p>
     *
     * <p>A client's own fitter that finds its structure in one go:</p>
     *
     * <listing>
     * public class OriginSphereFitter extends Fitter
     * {
     *     override protected function findStructure(session:FitSession):BoundingStructure
     *     {
     *         var v:Vector.&lt;Number&gt; = session.vertices;
     *         var radius:Number = 0;
     *         for (var i:int = 0; i &lt; v.length; i += 3)
     *         {
     *             radius = Math.max(radius, new Vector3D(v[i], v[i + 1], v[i + 2]).length);
     *         }
     *         return new Sphere(new Vector3D(), radius);
     *     }
     * }
     * </listing>
     */
    public class Fitter
    {
        private var _signature:String;

        /**
         * For subclasses only.
         *
         * @param signature the algorithm and its settings, as <code>signature</code> gives it; null for none
         */
        public function Fitter(signature:String = null)
        {
            _signature = signature;
        }

        /**
         * The algorithm and its settings in a few words: two fitters with the same signature find the same structures. Null for none: then the
         * structures are not kept in a FitStore or a baked file. A client's own fitter may have one, which has to change whenever its results do.
         */
        public function get signature():String
        {
            return _signature;
        }

        /**
         * Begins to find a structure around the vertices of a session: for a subclass that works in steps. The settings of the fitter count as they
         * are at this call.
         *
         * @param session the vertices, and their hull; it may not be there before the first step
         * @return the work, not begun yet
         */
        public function begin(session:FitSession):Fit
        {
            return new Fit(session, findStructure);
        }

        /**
         * Finds a structure around the vertices of a session in one go: for a subclass that does not implement <code>begin()</code>.
         *
         * @param session the vertices, and their hull
         */
        protected function findStructure(session:FitSession):BoundingStructure
        {
            throw new IllegalOperationError(this + " implements neither findStructure nor begin");
        }

        /**
         * Finds a structure around the vertices. For several fits of the same vertices <code>fitOnce()</code> is faster.
         *
         * @param vertices x, y, z of each vertex; not changed
         * @return a new structure, in the vertices' space and unit
         * @throws ArgumentError if the vertices are null or empty, their number of coordinates is no multiple of 3, or one is
         *         not finite
         */
        public final function fit(vertices:Vector.<Number>):BoundingStructure
        {
            return fitOnce(new FitSession(vertices));
        }

        /**
         * What <code>fit()</code> finds for a session's vertices: found at the first call for a session, and the same object at
         * every other.
         *
         * @param session the vertices, and their hull
         */
        public final function fitOnce(session:FitSession):BoundingStructure
        {
            var work:Fit = beginOnce(session);
            finish(work);
            return work.structure;
        }

        /**
         * The fit of a session's vertices: begun at the first call for a session, and the same object at every other. So a box
         * that a capsule is built from is found once.
         *
         * @param session the vertices, and their hull
         */
        public final function beginOnce(session:FitSession):Fit
        {
            return session.fitOf(this);
        }
    }
}
