package support
{
    import flash.events.Event;
    import flash.net.URLLoader;
    import flash.net.URLRequest;

    /** Fetches nothing until it is told to, and tells what was asked of it. */
    public class RecordingURLLoader extends URLLoader
    {
        /** The addresses that were asked for. */
        public var addresses:Array = [];

        /** How often it was closed. */
        public var closeCount:int = 0;

        public function RecordingURLLoader()
        {
        }

        /** Delivers a file, whether anybody waits for it or not. */
        public function deliver(content:*):void
        {
            data = content;
            dispatchEvent(new Event(Event.COMPLETE));
        }

        override public function load(request:URLRequest):void
        {
            addresses.push(request.url);
        }

        override public function close():void
        {
            closeCount++;
        }
    }
}
