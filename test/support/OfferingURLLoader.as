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
        private var _problem:String;

        /**
         * @param files what there is, by address
         * @param problem the text of the error for all else
         */
        public function OfferingURLLoader(files:Object, problem:String = "404")
        {
            _files = files;
            _problem = problem;
        }

        override public function load(request:URLRequest):void
        {
            data = _files[request.url];
            dispatchEvent(data == undefined ? new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, _problem) : new Event(Event.COMPLETE));
        }

        override public function close():void
        {
        }
    }
}
