package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Knows when and where a moving model touches what its surfaces cannot pass: another model (TreePair), or the ground. It is set to the two before
     * each question. The function sweepModel() puts its answers together.
     *
     * @private
     */
    public interface ImpactQuery
    {
        /** Whether the two touch where the motion has brought the model at a time. */
        function areTouchingAt(motion:RelativeMotion, time:Number):Boolean;

        /**
         * Finds when and where the surfaces of the two first touch. The parameters are those of sweepModel(). If one of the two begins wholly inside of
         * the other, that is no touch of surfaces.
         */
        function findImpact(motion:RelativeMotion, out:ContactPoint):void;

        /**
         * Finds the contact of the two, which overlap at the motion's time.
         *
         * @param motion of the model
         * @param out receives the contact, in the world
         */
        function findContact(motion:RelativeMotion, out:ContactPoint):void;
    }
}
