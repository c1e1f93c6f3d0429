package flash.net
{
    /** What a URLLoader makes of a file. */
    public final class URLLoaderDataFormat
    {
        /** A ByteArray. */
        public static const BINARY:String = "binary";

        /** A String. */
        public static const TEXT:String = "text";
    }
}
