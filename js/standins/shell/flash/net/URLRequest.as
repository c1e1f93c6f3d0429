package flash.net
{
    /** What to load. */
    public final class URLRequest
    {
        public var url:String;

        public function URLRequest(url:String = null)
        {
            this.url = url;
        }
    }
}
