package standin
{
    import flash.utils.ByteArray;

    /** The page's local storage; machine.mjs has how. */
    public final class LocalStore
    {
        /** The bytes under a name; null if there are none. */
        public static native function read(name:String):ByteArray;

        /** Keeps bytes; returns whether they are kept. */
        public static native function write(name:String, bytes:ByteArray):Boolean;

        /** Forgets what is under a name. */
        public static native function remove(name:String):void;
    }
}
