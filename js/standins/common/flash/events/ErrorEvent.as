package flash.events
{
    /** Sent if something failed. The text says what. */
    public class ErrorEvent extends TextEvent
    {
        public static const ERROR:String = "error";

        private var _id:int;

        public function ErrorEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, text:String = "", id:int = 0)
        {
            super(type, bubbles, cancelable, text);
            _id = id;
        }

        public function get errorID():int
        {
            return _id;
        }

        override public function clone():Event
        {
            return new ErrorEvent(type, bubbles, cancelable, text, errorID);
        }
    }
}
