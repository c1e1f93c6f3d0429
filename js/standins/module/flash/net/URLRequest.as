package flash.net
{
    /** What a URLLoader is to fetch: stands in for as much of Flash's class as names a file. */
    public final class URLRequest
    {
        /** The file's address. */
        public var url:String;

        /** @param url the file's address */
        public function URLRequest(url:String = null)
        {
            this.url = url;
        }
    }
}
