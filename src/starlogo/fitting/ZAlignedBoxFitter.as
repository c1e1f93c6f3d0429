package starlogo.fitting
{
    /**
     * The smallest box with one axis along z among those turned about z by the multiples of an increment below 90 degrees
     * (thesis §3.4.2). For models that only turn about z, which is what a heading does.
     *
     * <p>Never larger than the axis-aligned box. At the default each side is at most 9 % longer than that of the best box with
     * an axis along z.</p>
     */
    public final class ZAlignedBoxFitter extends TurnedBoxFitter
    {
        /**
         * A fitter that tries rotations of this step.
         *
         * @param degIncrement the step in degrees, above 0; 90 or more leaves the axis-aligned box alone
         * @throws ArgumentError if it is not a positive, finite number
         */
        public function ZAlignedBoxFitter(degIncrement:Number = 10)
        {
            super("z-aligned box", false, degIncrement);
        }
    }
}
