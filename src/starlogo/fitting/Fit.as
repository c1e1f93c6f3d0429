package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * A fit under way: what a fitter does for a session, in steps. After the last one the session's <code>fit()</code> has the
     * result at hand.
     *
     * <p>This one does all in a single step. A fitter that takes more than a few milliseconds for thousands of vertices begins one
     * of a subclass, which implements <code>advance()</code>. Settings of the fitter count as they are when the fit
     * begins.</p>
     */
    public class Fit implements Steps
    {
        private var _session:FitSession;
        private var _fitter:Fitter;

        /**
         * @param session the vertices, and their hull; it may not be there before the first step
         * @param fitter whose fit it is
         */
        public function Fit(session:FitSession, fitter:Fitter)
        {
            _session = session;
            _fitter = fitter;
        }

        /** The vertices, and their hull. */
        public function get session():FitSession
        {
            return _session;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            // another fit may have needed the same one
            return !_session.hasFitted(_fitter) && advance();
        }

        /** Does all steps that are left, and returns what was found. */
        public function run():BoundingStructure
        {
            var hasMore:Boolean = true;
            while (hasMore)
            {
                hasMore = step();
            }
            return _session.fit(_fitter);
        }

        /**
         * The next step; in the last one it calls <code>finish()</code>.
         *
         * @return whether there is more to do
         */
        protected function advance():Boolean
        {
            finish(_fitter.fitTo(_session));
            return false;
        }

        /** Hands in what was found. */
        protected function finish(structure:BoundingStructure):void
        {
            _session.keep(_fitter, structure);
        }
    }
}
