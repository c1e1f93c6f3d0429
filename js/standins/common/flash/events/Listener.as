package flash.events
{
    /** Who listens on a dispatcher for a type of event. */
    internal final class Listener
    {
        internal var call:Function;
        internal var isCapturing:Boolean;
        internal var priority:int;

        /** Whether it is called but once: not in Flash. */
        internal var isOnce:Boolean = false;

        public function Listener(call:Function, isCapturing:Boolean, priority:int)
        {
            this.call = call;
            this.isCapturing = isCapturing;
            this.priority = priority;
        }
    }
}
