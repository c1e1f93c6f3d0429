package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;

    /**
     * The cylinder along the longest axis of a box, as long as the box and as thick as the vertices need (thesis §3.4.3). To be
     * measured and shown, not collided: no intersection test takes cylinders (thesis §3.6.1). Cost beside the box: one pass over
     * the vertices.
     */
    public final class CylinderFitter extends Fitter
    {
        private var _boxFitter:Fitter;

        /**
         * A fitter of cylinders along the boxes of another fitter.
         *
         * @param boxFitter finds the box, or the fit fails with an ArgumentError
         * @throws ArgumentError if it is null
         */
        public function CylinderFitter(boxFitter:Fitter)
        {
            if (boxFitter == null)
            {
                throw new ArgumentError("the box's fitter must not be null");
            }
            _boxFitter = boxFitter;
        }

        /** What finds the box. */
        public function get boxFitter():Fitter
        {
            return _boxFitter;
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, findStructure, _boxFitter.beginOnce(session));
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var longest:LongestAxis = new LongestAxis(session, _boxFitter);
            return EnclosingStructures.cylinder(session.vertices, longest.center, longest.axis, longest.half);
        }
    }
}
