package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.minimal.SmallestEnclosingBall;

    /**
     * Finds the smallest bounding sphere (not in the thesis), exact except for rounding: about 1e-12 of the radius, and 1e-15 of the
     * largest coordinate. It usually takes 5 to 15 passes over the hull's vertices, and two over all vertices.
     */
    public final class MinimalSphereFitter extends Fitter
    {
        /** Creates a fitter of smallest spheres. */
        public function MinimalSphereFitter()
        {
            super("minimal sphere");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var ball:SmallestEnclosingBall = new SmallestEnclosingBall(session.hull.points);
            // Some vertices may be outside of the hull, by less than a step of its grid.
            ball.enclose(session.vertices);
            return EnclosingStructures.sphere(session.vertices, ball.center);
        }
    }
}
