package flash.events
{
    /** Sent if a file could not be read or written. */
    public class IOErrorEvent extends ErrorEvent
    {
        public static const IO_ERROR:String = "ioError";

        public function IOErrorEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, text:String = "",
                id:int = 0)
        {
            super(type, bubbles, cancelable, text, id);
        }

        override public function clone():Event
        {
            return new IOErrorEvent(type, bubbles, cancelable, text, errorID);
        }
    }
}
