package starlogo.fitting
{
    /**
     * The smallest box among those turned about x, y and z by multiples of an increment, each below 90 degrees
     * (thesis §3.4.2): 729 rotations at the default.
     *
     * <p>Never larger than the axis-aligned box, nor the z-aligned box of the same increment. Above the smallest box of all by a
     * few percent on most models; on thin ones that are turned it may be several times too large: see MinimalBoxFitter.</p>
     *
     * <p>The thesis rotates every vertex. This looks only at those on the hull, and finds the extreme ones of each rotation
     * by climbing over the hull from those of the rotation before: the boxes tried are the same, and so is the result.
     * Cost: n log n for the hull of n vertices; per rotation one native transformation of the hull and some steps.</p>
     */
    public final class OrientedBoxFitter extends TurnedBoxFitter
    {
        /**
         * A fitter that tries rotations of this step.
         *
         * @param degIncrement the step in degrees, above 0; halving it takes eight times as long
         * @throws ArgumentError if it is not a positive, finite number
         */
        public function OrientedBoxFitter(degIncrement:Number = 10)
        {
            super("oriented box", true, degIncrement);
        }
    }
}
