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
            _loader.addEventListener(Event.COMPLETE, onComplete);
            _loader.addEventListener(ProgressEvent.PROGRESS, onProgress);
            _loader.addEventListener(IOErrorEvent.IO_ERROR, onError);
            _loader.addEventListener(SecurityErrorEvent.SECURITY_ERROR, onError);
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

        private function onProgress(event:ProgressEvent):void
        {
            progress = event.bytesTotal > 0 ? Math.min(1, event.bytesLoaded / event.bytesTotal) : 0;
        }

        private function onComplete(event:Event):void
        {
            bytes = _loader.data;
            progress = 1;
            end();
        }

        private function onError(event:ErrorEvent):void
        {
            fail(event.text);
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
            _loader.removeEventListener(Event.COMPLETE, onComplete);
            _loader.removeEventListener(ProgressEvent.PROGRESS, onProgress);
            _loader.removeEventListener(IOErrorEvent.IO_ERROR, onError);
            _loader.removeEventListener(SecurityErrorEvent.SECURITY_ERROR, onError);
        }
    }
}
