package starlogo.libraries
{
    import flash.utils.ByteArray;

    /**
     * Where a FitStore keeps bytes from one game to the next, by name. It may lose them, change them or refuse more of them:
     * a FitStore checks what comes back.
     */
    public interface FitStorage
    {
        /** What is kept under a name, a copy; null if nothing is, or can't be read. Throws nothing. */
        function read(name:String):ByteArray;

        /**
         * Keeps bytes under a name, in place of what was there.
         *
         * @return whether they are kept now; if not, nothing is under the name. Throws nothing
         */
        function write(name:String, bytes:ByteArray):Boolean;

        /** Forgets what is kept under a name, if anything is. Throws nothing. */
        function remove(name:String):void;
    }
}
