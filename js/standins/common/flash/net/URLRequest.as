package flash.net
{
    /** The address of a file for a URLLoader. It has only the members of Flash's class that are needed for this. */
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
