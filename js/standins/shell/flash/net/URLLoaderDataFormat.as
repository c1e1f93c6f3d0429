package flash.net
{
    /** As what to load it. */
    public final class URLLoaderDataFormat
    {
        public static const BINARY:String = "binary";
        public static const TEXT:String = "text";
    }
}
