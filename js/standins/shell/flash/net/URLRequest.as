package flash.net
{
    /** The address of a file to load. */
    public final class URLRequest
    {
        public var url:String;

        public function URLRequest(url:String = null)
        {
            this.url = url;
        }
    }
}
