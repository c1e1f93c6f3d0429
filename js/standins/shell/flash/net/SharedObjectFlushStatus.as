package flash.net
{
    /** The results of flush(). */
    public final class SharedObjectFlushStatus
    {
        public static const FLUSHED:String = "flushed";
    }
}
