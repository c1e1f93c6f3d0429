package standin
{
    import flash.utils.ByteArray;

    /** The page's local storage. The code is in machine.mjs. */
    public final class LocalStore
    {
        /** The bytes under a name; null if there are none. */
        public static native function read(name:String):ByteArray;

        /** Stores bytes. Returns whether they are stored. */
        public static native function write(name:String, bytes:ByteArray):Boolean;

        /** Removes the bytes under a name. */
        public static native function remove(name:String):void;
    }
}
