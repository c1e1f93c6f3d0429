package flash.net
{
    /** What to load. */
    public final class URLRequest
    {
        public var url:String;
        public var method:String = "GET";
        public var data:Object = null;
        public var contentType:String = null;
        public var requestHeaders:Array = [];

        public function URLRequest(url:String = null)
        {
            this.url = url;
        }
    }
}
