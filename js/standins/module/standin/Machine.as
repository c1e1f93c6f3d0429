package standin
{
    /** What the stand-ins need of the machine beneath; machine.mjs has how. */
    public final class Machine
    {
        /** Milliseconds from some moment on, with fractions. */
        public static native function now():Number;

        /** Told of what a listener threw, and of error events that nothing listens for. */
        public static native function uncaught(error:*):void;

        /** The error of an error event that nothing listens for. */
        public static native function unheard(type:String, text:String):Error;

        /** Calls back once, when so many milliseconds are over. */
        public static native function setTimeout(callback:Function, ms:Number):uint;

        /** Takes back what setTimeout promised. */
        public static native function clearTimeout(id:uint):void;

        /** The name of an object's class. */
        public static native function className(value:*):String;

        /** Who listens for frames: EventDispatchers, each once. */
        public static native function get frameListeners():Array;
    }
}
