package starlogo.agents
{
    /**
     * Tells the records of one user of agents (a collider, a Collision) from those of others, and whether the user still
     * uses them.
     *
     * <p>Nobody tells when a user is let go of. One that has been silent while others were used many times over counts as
     * gone: agents drop its records when they get new ones. A user that comes back finds none and makes them again.</p>
     *
     * @private
     */
    public final class CacheToken
    {
        // A user is expected back within twice as many uses of others as any user has been away, but for extremes.
        private static const SHORTEST_ABSENCE:int = 16;
        private static const LONGEST_ABSENCE:int = 1000;

        private static var sUses:int = 0;
        private static var sAbsence:int = SHORTEST_ABSENCE;

        private var _lastUse:int;

        /** A user's first token, or one that voids all its records. */
        public function CacheToken()
        {
            _lastUse = ++sUses;
        }

        /**
         * Notes a use: a search, a frame.
         *
         * @return whether agents may have dropped the user's records since the last
         */
        public function noteUse():Boolean
        {
            var away:int = ++sUses - _lastUse;
            var absence:int = 2 * away;
            if (absence > sAbsence)
            {
                sAbsence = absence < LONGEST_ABSENCE ? absence : LONGEST_ABSENCE;
            }
            _lastUse = sUses;
            return away > SHORTEST_ABSENCE;
        }

        /** Makes all its records void. */
        public function revoke():void
        {
            _lastUse = int.MIN_VALUE / 2;
        }

        /** Whether records with this token may be dropped. */
        public function get isStale():Boolean
        {
            return sUses - _lastUse > sAbsence;
        }
    }
}
