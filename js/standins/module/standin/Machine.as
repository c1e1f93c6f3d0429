package standin
{
    /** The stand-ins' access to the machine. The code is in machine.mjs. */
    public final class Machine
    {
        /** Milliseconds since some fixed moment, with fractions. */
        public static native function now():Number;

        /** Called with errors that listeners threw, and with error events without a listener. */
        public static native function reportError(error:*):void;

        /** The error for an error event without a listener. */
        public static native function unhandledEvent(type:String, text:String):Error;

        /** Calls a function once, after this time. */
        public static native function setTimeout(callback:Function, ms:Number):uint;

        /** Cancels a setTimeout. */
        public static native function clearTimeout(id:uint):void;

        /** The name of an object's class. */
        public static native function className(value:*):String;

        /** Sends frames to an EventDispatcher from now on. */
        public static native function addFrameListener(dispatcher:Object):void;

        /** Sends it no more frames. */
        public static native function removeFrameListener(dispatcher:Object):void;
    }
}
