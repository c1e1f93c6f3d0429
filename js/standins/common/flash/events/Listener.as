package flash.events
{
    /** A listener for a type of event. */
    internal final class Listener
    {
        internal var type:String;

        /** null after the only call of a listener that is called once: a dispatch around that one still has it in its list. */
        internal var call:Function;
        internal var priority:int;

        /** Whether it is removed after the first call. Flash has no such listeners. */
        internal var isOnce:Boolean = false;

        public function Listener(type:String, call:Function, priority:int)
        {
            this.type = type;
            this.call = call;
            this.priority = priority;
        }
    }
}
