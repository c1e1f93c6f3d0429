package flash.net
{
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.utils.ByteArray;
    import standin.Machine;

    /** Reads files. A file arrives after the frame that asks for it. */
    public class URLLoader extends EventDispatcher
    {
        public var data:* = undefined;
        public var dataFormat:String = URLLoaderDataFormat.TEXT;
        public var bytesLoaded:uint = 0;
        public var bytesTotal:uint = 0;

        private var _pending:uint = 0;

        public function URLLoader(request:URLRequest = null)
        {
            if (request != null)
            {
                load(request);
            }
        }

        public function load(request:URLRequest):void
        {
            var url:String = request.url;
            Machine.clearTimeout(_pending);
            _pending = Machine.setTimeout(function():void
                {
                    read(url);
                }, 0);
        }

        public function close():void
        {
            Machine.clearTimeout(_pending);
        }

        private function read(url:String):void
        {
            var bytes:ByteArray = Machine.readFile(url);
            if (bytes == null)
            {
                dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "Error #2032: Stream Error. URL: " + url, 2032));
                return;
            }
            bytesLoaded = bytesTotal = bytes.length;
            dispatchEvent(new Event(Event.OPEN));
            dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, bytesLoaded, bytesTotal));
            data = dataFormat == URLLoaderDataFormat.BINARY ? bytes : bytes.readUTFBytes(bytes.length);
            dispatchEvent(new Event(Event.COMPLETE));
        }
    }
}
