package support
{
    /** How much the long tests try: what is enough for every day, or with <code>-Dfull</code> all they can. */
    public final class Effort
    {
        /** Whether they try all they can. The test SWF sets it before any test. */
        public static var isFull:Boolean = false;

        /**
         * Whether the player interprets, some thirty times as slowly as Node runs the same test whole: there a test may leave out the
         * largest cases. The test SWF sets it before any test; never with <code>-Dfull</code>.
         */
        public static var isInterpreted:Boolean = false;

        /** The number for this run; the last, if it is given, where the player interprets. */
        public static function choose(everyDay:int, full:int, interpreted:int = 0):int
        {
            return isFull ? full : isInterpreted && interpreted > 0 ? interpreted : everyDay;
        }
    }
}
