package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the first moment at which a moving model touches another one or the ground, and the contact then.
     *
     * <p>To get inside of a closed surface from outside, a part of the model has to cross it. So the surfaces are tested over time, and the
     * standing test is made only at the beginning and the end. At the end it is made because rounding can miss a touch there.</p>
     *
     * @param query is set to the two
     * @param motion of the model; receives the time
     * @param out receives the contact, in the world; null if only the time is needed
     * @private
     */
    public function sweepModel(query:ImpactQuery, motion:RelativeMotion, out:ContactPoint):void
    {
        var time:Number = 0;
        if (!query.areTouchingAt(motion, 0))
        {
            query.findImpact(motion, out);
            if (motion.time != RelativeMotion.NEVER)
            {
                return;
            }
            time = query.areTouchingAt(motion, motion.latest) ? motion.latest : RelativeMotion.NEVER;
        }
        motion.time = time;
        if (out != null && time != RelativeMotion.NEVER)
        {
            query.findContact(motion, out);
        }
    }
}
