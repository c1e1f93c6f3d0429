package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.fitting.Fitter;

    /** Finds a sphere that is large enough for every model, and counts how often. */
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
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, function(session:FitSession):BoundingStructure
                {
                    count++;
                    return new Sphere(new Vector3D(), 100);
                });
        }
    }
}
