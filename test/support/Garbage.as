package support
{
    import org.flexunit.assumeThat;
    import org.hamcrest.object.equalTo;

    /** What the player that tests run in can tell of allocations. The test SWF sets it before any test. */
    public final class Garbage
    {
        /** Whether memory grows by whatever is allocated, and never shrinks: Adobe's VM with its collector off. */
        public static var isCounted:Boolean = false;

        /** Whether the collector runs whenever it likes, so that memory tells nothing: Adobe's VM otherwise. */
        public static var isCollected:Boolean = false;

        /** Skips the test if memory tells nothing. */
        public static function assumeKept():void
        {
            assumeThat(isCollected, equalTo(false));
        }
    }
}
