package flash.events
{
    /** Sent when a key is pressed or released. Here only programs send it. */
    public class KeyboardEvent extends Event
    {
        public static const KEY_DOWN:String = "keyDown";
        public static const KEY_UP:String = "keyUp";

        public var charCode:uint;
        public var keyCode:uint;

        public function KeyboardEvent(type:String, bubbles:Boolean = true, cancelable:Boolean = false, charCode:uint = 0, keyCode:uint = 0)
        {
            super(type, bubbles, cancelable);
            this.charCode = charCode;
            this.keyCode = keyCode;
        }

        override public function clone():Event
        {
            return new KeyboardEvent(type, bubbles, cancelable, charCode, keyCode);
        }
    }
}
