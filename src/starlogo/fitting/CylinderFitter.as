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
         * @param boxFitter finds the box
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

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the fitter that was given for the box finds something else
         */
        override public function fitTo(session:FitSession):BoundingStructure
        {
            var spine:BoxSpine = new BoxSpine(session, _boxFitter);
            return Enclosing.cylinder(session.vertices, spine.center, spine.axis, spine.half);
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            return new SpineFit(session, this, _boxFitter);
        }
    }
}
