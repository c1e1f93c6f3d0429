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
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return "naive sphere";
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, find);
        }

        private function find(session:FitSession):BoundingStructure
        {
            var box:ExtremePoints = new ExtremePoints(session.hull.points);
            return EnclosingStructures.sphere(session.vertices, (box.lowX + box.highX) / 2, (box.lowY + box.highY) / 2,
                    (box.lowZ + box.highZ) / 2);
        }
    }
}
