package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.hierarchy.RelativePose;

    /**
     * Finds when and where the two models of a TreePair first touch while a moves relative to b.
     *
     * @private
     */
    public final class TreePairImpactQuery extends ImpactQuery
    {
        private var _pair:TreePair = null;

        // The motion of b in a's space, from the pair's pose on.
        private var _motion:RelativeMotion = new RelativeMotion();

        /** Sets the two models. Call it before each question. */
        public function setTo(pair:TreePair):void
        {
            _pair = pair;
        }

        /** @inheritDoc */
        override public function areTouchingAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pair.relateAt(motion, time);
            return _pair.areTouchingInPose();
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.relateAt(motion, 0);
            RelativePose.relateMotion(_pair.placementA, motion, _motion);
            _pair.findImpact(_motion, out);
            motion.time = _motion.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                RelativePose.moveContactToWorld(out, _pair.placementA, motion);
            }
        }

        /**
         * Does what <code>findImpact()</code> does, and finds whether one of the two begins inside of the other.
         *
         * @return whether one is inside of the other and their surfaces do not touch where the motion begins
         */
        public function findImpactAndInside(motion:RelativeMotion, out:ContactPoint):Boolean
        {
            findImpact(motion, out);
            return motion.time > 0 && _pair.findInside(null);
        }

        /**
         * It is the contact of two triangles that touch there, or of two nodes that decide. If one model is inside of the other, it is the contact of
         * the boxes of their roots.
         *
         * @inheritDoc
         */
        override public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.relateAt(motion, motion.time);
            RelativePose.relateMotion(_pair.placementA, motion, _motion);
            // Only what touches at once counts. The motion turns the contact to a plane that it comes against.
            _motion.latest = 0;
            _pair.findImpact(_motion, out);
            if (_motion.time == RelativeMotion.NEVER)
            {
                _motion.time = 0;
                _pair.findContactOfRoots(_motion, out);
            }
            RelativePose.moveContactToWorld(out, _pair.placementA, motion);
        }
    }
}
