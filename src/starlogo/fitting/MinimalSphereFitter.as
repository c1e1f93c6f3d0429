package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.steps.StepSequence;

    /**
     * The smallest sphere of all (beyond the thesis; see SmallestEnclosingBall): exact but for rounding, about 1e-12 of the radius. Usually
     * 5 to 15 passes over the hull's vertices, and two over all.
     */
    public final class MinimalSphereFitter extends Fitter
    {
        /** A fitter of smallest spheres. */
        public function MinimalSphereFitter()
        {
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return "minimal sphere";
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            var ball:SmallestEnclosingBall;
            // the hull leaves out what is outside of it by less than its grid's step
            var enclosing:StepSequence = new StepSequence().call(function():void
                {
                    ball = new SmallestEnclosingBall(session.hull.points);
                }).call(function():void
                {
                    ball.enclose(session.vertices);
                });
            return new Fit(session, function(session:FitSession):BoundingStructure
                {
                    return EnclosingStructures.sphere(session.vertices, ball.x, ball.y, ball.z);
                }, enclosing);
        }
    }
}
