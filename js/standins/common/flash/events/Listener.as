package flash.events
{
    /** A listener for a type of event. */
    internal final class Listener
    {
        /** null after the only call of a listener that is called once: a dispatch around that one still has it in its list. */
        internal var call:Function;
        internal var isCapturing:Boolean;
        internal var priority:int;

        /** Whether it is removed after the first call. Flash has no such listeners. */
        internal var isOnce:Boolean = false;

        public function Listener(call:Function, isCapturing:Boolean, priority:int)
        {
            this.call = call;
            this.isCapturing = isCapturing;
            this.priority = priority;
        }
    }
}
