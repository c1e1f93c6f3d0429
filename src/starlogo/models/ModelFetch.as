package starlogo.models
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

    /** A model's file that is being fetched. */
    internal final class ModelFetch
    {
        private static const EVENTS:Array = [Event.COMPLETE, ProgressEvent.PROGRESS, IOErrorEvent.IO_ERROR, SecurityErrorEvent.SECURITY_ERROR];

        /** Whether the file is still being fetched: neither complete, nor failed, nor cancelled. */
        public var isUnderWay:Boolean = true;

        /** How much of it is fetched, from 0 to 1. */
        public var progress:Number = 0;

        /** The file; null until it is fetched. */
        public var bytes:ByteArray = null;

        /** Why it cannot be fetched; null if there is no problem. */
        public var problem:String = null;

        private var _loader:URLLoader;

        /**
         * Starts to fetch a file.
         *
         * @param url where it is
         * @param loader fetches it
         */
        public function ModelFetch(url:String, loader:URLLoader)
        {
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
            if (isUnderWay)
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
            reason = plainMessage(reason);
            problem = "its file can't be fetched" + (reason == "" ? "" : ": " + reason);
            end();
        }

        private function end():void
        {
            isUnderWay = false;
            for each (var type:String in EVENTS)
            {
                _loader.removeEventListener(type, onEvent);
            }
        }
    }
}
