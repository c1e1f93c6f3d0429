package starlogo.fitting
{
    /**
     * Finds the smallest bounding box among those rotated about x, y and z by multiples of an increment, each below 90 degrees (thesis
     * §3.4.2). With the default increment these are 729 rotations.
     *
     * <p>The box is never larger than the axis-aligned box, or the z-aligned box with the same increment. For most models it is a few
     * percent larger than the smallest box. For thin models that are rotated it may be several times too large. If boxes have no volume,
     * because the model is flat, the one with the smallest area is the smallest.</p>
     *
     * <p>The thesis rotates every vertex. This class rotates only the vertices of the hull. It tries the same boxes as the thesis, so the
     * result is the same. The hull of n vertices costs n log n. Each rotation costs at most a pass over the hull's vertices.</p>
     */
    public final class OrientedBoxFitter extends Fitter
    {
        private var _degIncrement:Number;

        /**
         * Creates a fitter that tries all rotations by multiples of an increment.
         *
         * @param degIncrement in degrees, at least 0.01; half the increment takes eight times as long
         * @throws ArgumentError if it is less than 0.01, or not finite
         */
        public function OrientedBoxFitter(degIncrement:Number = 10)
        {
            this.degIncrement = degIncrement;
        }

        /**
         * The increment in degrees, at least 0.01.
         *
         * @throws ArgumentError if it is set to a value that is less than 0.01, or not finite
         */
        public function get degIncrement():Number
        {
            return _degIncrement;
        }

        public function set degIncrement(value:Number):void
        {
            _degIncrement = RotationSearch.checkedIncrement(value);
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return "oriented box " + _degIncrement;
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            var search:RotationSearch = new RotationSearch(session, _degIncrement, _degIncrement);
            return new Fit(session, search.smallestBox, search);
        }
    }
}
