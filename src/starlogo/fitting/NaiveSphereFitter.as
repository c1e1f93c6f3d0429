package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;

    /**
     * The sphere around the middle of the axis-aligned box (thesis §3.4.1, the naive algorithm): at most 1.73 times the
     * smallest radius, usually much closer. Two passes over the vertices.
     */
    public final class NaiveSphereFitter extends Fitter
    {
        /** A fitter of naive spheres. */
        public function NaiveSphereFitter()
        {
            super("naive sphere");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var box:ExtremePoints = new ExtremePoints(session.hull.points);
            return EnclosingStructures.sphere(session.vertices, box.middle(0), box.middle(1), box.middle(2));
        }
    }
}
