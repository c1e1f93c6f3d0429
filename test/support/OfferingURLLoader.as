package support
{
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLRequest;

    /** Has files at hand in place of fetching them. */
    public class OfferingURLLoader extends URLLoader
    {
        private var _files:Object;

        /** @param files what there is, by address */
        public function OfferingURLLoader(files:Object)
        {
            _files = files;
        }

        override public function load(request:URLRequest):void
        {
            data = _files[request.url];
            dispatchEvent(data == undefined ? new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "404") : new Event(Event.COMPLETE));
        }

        override public function close():void
        {
        }
    }
}
