package flash.events
{
    /** A server answered. */
    public class HTTPStatusEvent extends Event
    {
        public static const HTTP_STATUS:String = "httpStatus";

        private var _status:int;

        public function HTTPStatusEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, status:int = 0)
        {
            super(type, bubbles, cancelable);
            _status = status;
        }

        public function get status():int
        {
            return _status;
        }

        override public function clone():Event
        {
            return new HTTPStatusEvent(type, bubbles, cancelable, status);
        }

        override public function toString():String
        {
            return formatToString("HTTPStatusEvent", "type", "bubbles", "cancelable", "eventPhase", "status");
        }
    }
}
