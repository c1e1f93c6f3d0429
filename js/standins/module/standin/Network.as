package standin
{
    /** Fetches files. The code is in machine.mjs. */
    public final class Network
    {
        /**
         * Begins to fetch a file.
         *
         * @param url its address
         * @param onProgress <code>(loaded:uint, total:uint):void</code>
         * @param onDone <code>(bytes:Object):void</code>
         * @param onError <code>(problem:String):void</code>
         * @return a function that stops it
         */
        public static native function fetch(url:String, onProgress:Function, onDone:Function, onError:Function):Function;
    }
}
