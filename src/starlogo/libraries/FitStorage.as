package starlogo.libraries
{
    import flash.utils.ByteArray;

    /**
     * Stores the bytes of a FitStore between games, by name. It may lose, change or refuse bytes, because a FitStore ignores what is missing
     * or damaged.
     */
    public interface FitStorage
    {
        /** A copy of the bytes under a name; null if there are none, or they can't be read. Anything but a ByteArray counts as null. Never throws. */
        function read(name:String):ByteArray;

        /**
         * Stores bytes under a name and replaces the bytes stored there before. A FitStore takes a refusal for a lack of room: it removes other
         * entries with as many bytes, asks once more, and stores no more bytes until it is cleared. Never throws.
         *
         * @return whether the bytes are stored; if not, nothing is stored under the name
         */
        function write(name:String, bytes:ByteArray):Boolean;

        /** Removes the bytes under a name, if there are any. Never throws. */
        function remove(name:String):void;
    }
}
