package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * A Fitter's work for the vertices of a session, in steps. It begins with the session's own steps, which compute the hull, and may go on
     * with other work that has steps. The last step finds the structure.
     */
    public final class Fit implements Steps
    {
        private var _work:StepSequence = new StepSequence();
        private var _structure:BoundingStructure = null;

        /**
         * Creates a fit that has not begun.
         *
         * @param session the vertices, and their hull
         * @param find finds the structure: <code>function(session:FitSession):BoundingStructure</code>. It is called in the last step. Work
         *     that takes more than a few milliseconds for thousands of vertices belongs in the steps before it
         * @param before work that has to be done before; null for none
         */
        public function Fit(session:FitSession, find:Function, before:Steps = null)
        {
            _work.add(session);
            if (before != null)
            {
                _work.add(before);
            }
            _work.call(function():void
                {
                    _structure = find(session);
                });
        }

        /** The structure; null until the last step. */
        public function get structure():BoundingStructure
        {
            return _structure;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }
    }
}
