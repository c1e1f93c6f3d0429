package flash.net
{
    /** What flush() answers. */
    public final class SharedObjectFlushStatus
    {
        public static const FLUSHED:String = "flushed";
    }
}
