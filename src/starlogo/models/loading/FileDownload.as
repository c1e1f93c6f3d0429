package starlogo.models.loading
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.events.SecurityErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLLoaderDataFormat;
    import flash.net.URLRequest;
    import flash.utils.ByteArray;

    /**
     * The download of one file: of a model, or the list of cooked files.
     *
     * @private
     */
    public final class FileDownload
    {
        private static const EVENTS:Array = [Event.COMPLETE, ProgressEvent.PROGRESS, IOErrorEvent.IO_ERROR, SecurityErrorEvent.SECURITY_ERROR];

        /** Whether the download is running: it is not complete, not cancelled, and has not failed. */
        public var isRunning:Boolean = true;

        /** The share that has arrived, from 0 to 1. */
        public var progress:Number = 0;

        /** The file; null until it has arrived. */
        public var bytes:ByteArray = null;

        /** Why the file cannot be fetched; null if there is no problem. */
        public var problem:String = null;

        private var _url:String;
        private var _loader:URLLoader;

        /**
         * Starts to fetch a file.
         *
         * @param url the file's address
         * @param loader fetches it
         */
        public function FileDownload(url:String, loader:URLLoader)
        {
            _url = url;
            _loader = loader;
            _loader.dataFormat = URLLoaderDataFormat.BINARY;
            for each (var type:String in EVENTS)
            {
                _loader.addEventListener(type, onEvent);
            }
            try
            {
                _loader.load(new URLRequest(url));
            }
            catch (error:Error)
            {
                fail(error.message);
            }
        }

        /** Stops fetching. */
        public function cancel():void
        {
            if (isRunning)
            {
                end();
                _loader.close();
            }
        }

        private function onEvent(event:Event):void
        {
            var passing:ProgressEvent = event as ProgressEvent;
            if (passing != null)
            {
                progress = passing.bytesTotal > 0 ? Math.min(1, passing.bytesLoaded / passing.bytesTotal) : 0;
            }
            else if (event is ErrorEvent)
            {
                fail(ErrorEvent(event).text);
            }
            else
            {
                bytes = _loader.data;
                progress = 1;
                end();
            }
        }

        private function fail(reason:String):void
        {
            // The player's message without its number and without the words before the address: "Error #2032: Stream Error. URL: bear.obj"
            // becomes "bear.obj". A message without an address becomes the reason in brackets.
            reason = reason.replace(/^Error #\d+: (Stream Error(\. |$))?(URL: )?/, "");
            if (reason.indexOf(_url) < 0)
            {
                reason = _url + (reason == "" ? "" : " (" + reason + ")");
            }
            problem = "its file can't be fetched: " + reason;
            end();
        }

        private function end():void
        {
            isRunning = false;
            for each (var type:String in EVENTS)
            {
                _loader.removeEventListener(type, onEvent);
            }
        }
    }
}
