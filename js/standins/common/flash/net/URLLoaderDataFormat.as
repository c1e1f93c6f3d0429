package flash.net
{
    /** The types in which a URLLoader returns a file. */
    public final class URLLoaderDataFormat
    {
        /** A ByteArray. */
        public static const BINARY:String = "binary";

        /** A String. */
        public static const TEXT:String = "text";
    }
}
