package flash.events
{
    /** Data came. */
    public class DataEvent extends TextEvent
    {
        public static const DATA:String = "data";

        public function DataEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, text:String = "")
        {
            super(type, bubbles, cancelable, text);
        }

        override public function clone():Event
        {
            return new DataEvent(type, bubbles, cancelable, text);
        }
    }
}
