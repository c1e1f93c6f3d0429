package standin
{
    import flash.utils.ByteArray;

    /** Reads files. A file arrives after the frame that asks for it. */
    public final class Network
    {
        /** Begins to read a file: see the module's Network. */
        public static function fetch(url:String, onProgress:Function, onDone:Function, onError:Function):Function
        {
            var isStopped:Boolean = false;
            Machine.setTimeout(function():void
                {
                    var bytes:ByteArray = isStopped ? null : Machine.readFile(url);
                    if (bytes != null)
                    {
                        onProgress(bytes.length, bytes.length);
                    }
                    // the progress may be a reason to stop
                    if (isStopped)
                    {
                        return;
                    }
                    if (bytes == null)
                    {
                        onError("there is no such file");
                    }
                    else
                    {
                        onDone(bytes);
                    }
                }, 0);
            return function():void
            {
                isStopped = true;
            };
        }
    }
}
