package flash.events
{
    import standin.Machine;

    /** An event with a text. */
    public class TextEvent extends Event
    {
        public static const LINK:String = "link";

        public var text:String;

        public function TextEvent(type:String, bubbles:Boolean = false, cancelable:Boolean = false, text:String = "")
        {
            super(type, bubbles, cancelable);
            this.text = text;
        }

        override public function clone():Event
        {
            return new TextEvent(type, bubbles, cancelable, text);
        }

        override public function toString():String
        {
            return formatToString(Machine.className(this).split("::").pop(), "type", "bubbles", "cancelable", "eventPhase", "text");
        }
    }
}
