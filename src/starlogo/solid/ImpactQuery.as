package starlogo.solid
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds when and where a moving model first touches what its surfaces cannot pass: another model (TreeQuery), or the ground. Abstract: a subclass is
     * set to the two before each question.
     *
     * <p>To get inside of a closed surface from outside, a part of the model has to cross it. So the surfaces are tested over time, and the
     * standing test is made only at the beginning and the end.</p>
     *
     * @private
     */
    public class ImpactQuery
    {
        /**
         * Finds the first moment at which the two touch while the model moves, and the contact then. Rounding can miss a touch at the latest time.
         * So if nothing is found before, the standing test is made at that time too.
         *
         * @param motion of the model; receives the time
         * @param out receives the contact, in the world; null if only the time is needed
         */
        public final function findFirstTouch(motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = 0;
            if (!areTouchingAt(motion, 0))
            {
                findImpactOfSurfaces(motion, out);
                if (motion.time != RelativeMotion.NEVER)
                {
                    return;
                }
                time = areTouchingAt(motion, motion.latestTime) ? motion.latestTime : RelativeMotion.NEVER;
            }
            motion.time = time;
            if (out != null && time != RelativeMotion.NEVER)
            {
                findContact(motion, out);
            }
        }

        /** Whether the two touch where the motion has brought the model at a time. */
        public function areTouchingAt(motion:RelativeMotion, time:Number):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouchingAt");
        }

        /**
         * Finds when and where the surfaces of the two first touch. The parameters are those of <code>findFirstTouch()</code>. If one of the two begins
         * wholly inside of the other, that is no touch of surfaces.
         */
        public function findImpactOfSurfaces(motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findImpactOfSurfaces");
        }

        /**
         * Finds the contact of the two, which overlap at the motion's time.
         *
         * @param motion of the model
         * @param out receives the contact, in the world
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContact");
        }
    }
}
