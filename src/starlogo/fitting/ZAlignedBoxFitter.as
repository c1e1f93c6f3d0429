package starlogo.fitting
{
    /**
     * Finds the smallest bounding box with one axis along z, among those rotated about z by multiples of an increment below 90 degrees
     * (thesis §3.4.2). It is for models that only rotate about z, as a heading does.
     *
     * <p>The box is never larger than the axis-aligned box. The best box with an axis along z may be between two rotations that are tried. With
     * the default increment, one of the two is at most 5 degrees away. There the sides along the ground are longer by at most 9 % of the longest
     * of them, and the box that is found is not larger than that one. With an increment of 90 degrees or more, only the axis-aligned box is
     * tried.</p>
     */
    public final class ZAlignedBoxFitter extends Fitter
    {
        private var _degIncrement:Number;

        /**
         * Creates a fitter that tries all rotations about z by multiples of an increment.
         *
         * @param degIncrement in degrees, at least 0.01
         * @throws ArgumentError if it is less than 0.01, or not finite
         */
        public function ZAlignedBoxFitter(degIncrement:Number = 10)
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
            return "z-aligned box " + _degIncrement;
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            var search:RotationSearch = new RotationSearch(session, 90, _degIncrement);
            return new Fit(session, search.smallestBox, search);
        }
    }
}
