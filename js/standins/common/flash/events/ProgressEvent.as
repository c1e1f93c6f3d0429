package flash.events
{
    /** Sent while something is loading, with the bytes so far. */
    public class ProgressEvent extends Event
    {
        public static const PROGRESS:String = "progress";

        public var bytesLoaded:Number;
        public var bytesTotal:Number;

        public function ProgressEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false,
                bytesLoaded:Number = 0, bytesTotal:Number = 0)
        {
            super(type, bubbles, cancelable);
            this.bytesLoaded = bytesLoaded;
            this.bytesTotal = bytesTotal;
        }

        override public function clone():Event
        {
            return new ProgressEvent(type, bubbles, cancelable, bytesLoaded, bytesTotal);
        }

        override public function toString():String
        {
            return formatToString("ProgressEvent", "type", "bubbles", "cancelable", "eventPhase", "bytesLoaded", "bytesTotal");
        }
    }
}
