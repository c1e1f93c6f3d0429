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

        /** @param signature null if its structures are not to be stored */
        public function CountingFitter(signature:String = "counting")
        {
            super(signature);
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
