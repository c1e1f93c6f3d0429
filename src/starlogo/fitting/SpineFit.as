package starlogo.fitting
{
    import starlogo.steps.Steps;

    /** A fit along the longest axis of a box: the steps that find the box, and one more. */
    public final class SpineFit extends Fit
    {
        private var _boxFit:Steps;

        /**
         * @param session the vertices, and their hull
         * @param fitter whose fit it is
         * @param boxFitter finds the box
         */
        public function SpineFit(session:FitSession, fitter:Fitter, boxFitter:Fitter)
        {
            super(session, fitter);
            _boxFit = session.begin(boxFitter);
        }

        /** @inheritDoc */
        override protected function advance():Boolean
        {
            if (_boxFit == null)
            {
                return super.advance();
            }
            if (!_boxFit.step())
            {
                _boxFit = null;
            }
            return true;
        }
    }
}
