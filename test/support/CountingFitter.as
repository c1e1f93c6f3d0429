package support
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;

    /** Finds the axis-aligned box, and counts how often. */
    public class CountingFitter extends Fitter
    {
        /** How often it was asked. */
        public var count:int = 0;

        /** @inheritDoc */
        override public function get signature():String
        {
            return "counting";
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            return new Fit(session, function(session:FitSession):BoundingStructure
                {
                    count++;
                    return session.structureOf(new AxisAlignedBoxFitter());
                });
        }
    }
}
