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

    /** A model's file on its way here. */
    internal final class ModelFetch
    {
        private var _loader:URLLoader;
        private var _isUnderWay:Boolean = true;
        private var _progress:Number = 0;
        private var _bytes:ByteArray = null;
        private var _problem:String = null;

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
                fail("its file can't be fetched: " + error.message);
            }
        }

        /** Whether the file is still to come: neither here, nor failed, nor cancelled. */
        public function get isUnderWay():Boolean
        {
            return _isUnderWay;
        }

        /** How much of it is here, from 0 to 1. */
        public function get progress():Number
        {
            return _progress;
        }

        /** The file; null before it is here. */
        public function get bytes():ByteArray
        {
            return _bytes;
        }

        /** Why it won't come; null if nothing is known against it. */
        public function get problem():String
        {
            return _problem;
        }

        /** Stops fetching. */
        public function cancel():void
        {
            if (_isUnderWay)
            {
                end();
                _loader.close();
            }
        }

        private function onProgress(event:ProgressEvent):void
        {
            _progress = event.bytesTotal > 0 ? Math.min(1, event.bytesLoaded / event.bytesTotal) : 0;
        }

        private function onComplete(event:Event):void
        {
            _bytes = _loader.data;
            _progress = 1;
            end();
        }

        private function onError(event:ErrorEvent):void
        {
            fail("its file can't be fetched: " + event.text);
        }

        private function fail(problem:String):void
        {
            _problem = problem;
            end();
        }

        private function end():void
        {
            _isUnderWay = false;
            _loader.removeEventListener(Event.COMPLETE, onComplete);
            _loader.removeEventListener(ProgressEvent.PROGRESS, onProgress);
            _loader.removeEventListener(IOErrorEvent.IO_ERROR, onError);
            _loader.removeEventListener(SecurityErrorEvent.SECURITY_ERROR, onError);
        }
    }
}
