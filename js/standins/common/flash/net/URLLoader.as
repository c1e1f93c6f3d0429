package flash.net
{
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.utils.ByteArray;
    import standin.Network;

    /** Fetches a file, with these of Flash's events: progress, and complete or ioError. Unlike Flash's it sends no open. */
    public class URLLoader extends EventDispatcher
    {
        /** The file, after the event complete. */
        public var data:* = null;

        /** The type of data: see URLLoaderDataFormat. */
        public var dataFormat:String = URLLoaderDataFormat.TEXT;

        /** The number of bytes that have arrived. */
        public var bytesLoaded:uint = 0;

        /** The number of bytes of the file; 0 if it is not known. */
        public var bytesTotal:uint = 0;

        private var _stop:Function = null;

        /** @param request is loaded at once; null to wait for load() */
        public function URLLoader(request:URLRequest = null)
        {
            if (request != null)
            {
                load(request);
            }
        }

        /** Begins to fetch a file. A running download is stopped. */
        public function load(request:URLRequest):void
        {
            var url:String = request.url;
            if (url == null)
            {
                throw new TypeError("an address is needed, not null");
            }
            close();
            bytesLoaded = 0;
            bytesTotal = 0;
            _stop = Network.fetch(url, onProgress, onDone, function(problem:String):void
                {
                    _stop = null;
                    dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "Error #2032: Stream Error. URL: " + url + " (" + problem + ")"));
                });
        }

        /** Stops fetching. */
        public function close():void
        {
            if (_stop != null)
            {
                _stop();
                _stop = null;
            }
        }

        private function onProgress(loaded:uint, total:uint):void
        {
            bytesLoaded = loaded;
            bytesTotal = total;
            dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, loaded, total));
        }

        private function onDone(bytes:ByteArray):void
        {
            _stop = null;
            data = dataFormat == URLLoaderDataFormat.BINARY ? bytes : bytes.readUTFBytes(bytes.length);
            dispatchEvent(new Event(Event.COMPLETE));
        }
    }
}
