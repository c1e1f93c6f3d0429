package flash.net
{
    /** The forms of a loaded file. */
    public final class URLLoaderDataFormat
    {
        public static const BINARY:String = "binary";
        public static const TEXT:String = "text";
    }
}
