package flash.net
{
    import flash.events.EventDispatcher;
    import flash.events.IOErrorEvent;

    /** Is never connected. */
    public class XMLSocket extends EventDispatcher
    {
        public function get connected():Boolean
        {
            return false;
        }

        public function connect(host:String, port:int):void
        {
            dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "Error #2031: Socket Error."));
        }

        public function send(object:*):void
        {
        }

        public function close():void
        {
        }
    }
}
