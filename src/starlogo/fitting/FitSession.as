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

        // The work begun for the vertices, and the object that each was begun for.
        private var _owners:Vector.<Object> = new Vector.<Object>();
        private var _works:Vector.<Steps> = new Vector.<Steps>();

        /**
         * A session without fits.
         *
         * @param vertices x, y, z of each vertex; kept, not copied, and never changed
         * @param atOnce false leaves all, the check of the vertices too, to <code>step()</code>
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

        /** Their convex hull; what steps have left of it is done now. */
        public function get hull():ConvexHull
        {
            finish(_hull);
            return _hull;
        }

        /**
         * The work that was kept for an owner, which is any object; null if there is none.
         *
         * @private
         */
        engine function workOf(owner:Object):Steps
        {
            var i:int = _owners.indexOf(owner);
            return i < 0 ? null : _works[i];
        }

        /**
         * Keeps work, for all that need it.
         *
         * @private
         */
        engine function keep(owner:Object, work:Steps):void
        {
            _owners.push(owner);
            _works.push(work);
        }
    }
}
