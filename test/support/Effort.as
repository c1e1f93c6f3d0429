package support
{
    /** How much the long tests try: what is enough for every day, or with <code>-Dfull</code> all they can. */
    public final class Effort
    {
        /** Whether they try all they can. The test SWF sets it before any test. */
        public static var isFull:Boolean = false;

        /** The number for this run. */
        public static function choose(everyDay:int, full:int):int
        {
            return isFull ? full : everyDay;
        }
    }
}
