package support
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;

    /** Throws an error as soon as it is asked for a structure. */
    public class FailingFitter extends Fitter
    {
        private var _error:Error;

        /** @param error what it throws */
        public function FailingFitter(error:Error)
        {
            _error = error;
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            return new Fit(session, find);
        }

        private function find(session:FitSession):BoundingStructure
        {
            throw _error;
        }
    }
}
