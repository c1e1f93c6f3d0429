package flash.events
{
    /** Nobody caught an error. */
    public class UncaughtErrorEvent extends ErrorEvent
    {
        public static const UNCAUGHT_ERROR:String = "uncaughtError";

        public var error:Object;

        public function UncaughtErrorEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, error:Object = null)
        {
            super(type, bubbles, cancelable);
            this.error = error;
        }

        override public function clone():Event
        {
            return new UncaughtErrorEvent(type, bubbles, cancelable, error);
        }
    }
}
