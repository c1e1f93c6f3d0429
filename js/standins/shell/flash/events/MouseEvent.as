package flash.events
{
    /** Never sent: there is no mouse. */
    public class MouseEvent extends Event
    {
        public static const CLICK:String = "click";
        public static const MOUSE_DOWN:String = "mouseDown";
        public static const MOUSE_UP:String = "mouseUp";
        public static const MOUSE_MOVE:String = "mouseMove";
        public static const ROLL_OUT:String = "rollOut";
        public static const ROLL_OVER:String = "rollOver";

        public function MouseEvent(type:String, bubbles:Boolean = true, cancelable:Boolean = false)
        {
            super(type, bubbles, cancelable);
        }
    }
}
