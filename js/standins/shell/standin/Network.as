package standin
{
    import flash.utils.ByteArray;

    /** Reads files. A file arrives after the frame that asks for it. */
    public final class Network
    {
        /** Begins to read a file: see the module's Network. */
        public static function fetch(url:String, onProgress:Function, onDone:Function, onError:Function):Function
        {
            var pending:uint = Machine.setTimeout(function():void
                {
                    var bytes:ByteArray = Machine.readFile(url);
                    if (bytes == null)
                    {
                        onError("there is no such file");
                        return;
                    }
                    onProgress(bytes.length, bytes.length);
                    onDone(bytes);
                }, 0);
            return function():void
            {
                Machine.clearTimeout(pending);
            };
        }
    }
}
