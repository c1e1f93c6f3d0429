package flash.events
{
    /** A device tells of its state. */
    public class StatusEvent extends Event
    {
        public static const STATUS:String = "status";

        public var code:String;
        public var level:String;

        public function StatusEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, code:String = "",
                level:String = "")
        {
            super(type, bubbles, cancelable);
            this.code = code;
            this.level = level;
        }

        override public function clone():Event
        {
            return new StatusEvent(type, bubbles, cancelable, code, level);
        }

        override public function toString():String
        {
            return formatToString("StatusEvent", "type", "bubbles", "cancelable", "eventPhase", "code", "level");
        }
    }
}
