package flash.net
{
    import flash.events.EventDispatcher;

    /** Keeps data under a name while the program runs. */
    public class SharedObject extends EventDispatcher
    {
        private static var sAll:Object = {};

        private var _data:Object = {};

        /** The object with a name. It is created if there is none. */
        public static function getLocal(name:String, localPath:String = null, secure:Boolean = false):SharedObject
        {
            if (/[ ~%&\\;:"',<>?#]/.test(name))
            {
                throw new Error("Error #2085: Parameter name must be non-empty string.");
            }
            var key:String = localPath + ":" + name;
            sAll[key] ||= new SharedObject();
            return sAll[key];
        }

        /** The stored data. */
        public function get data():Object
        {
            return _data;
        }

        /** Stores the data. */
        public function flush(minDiskSpace:int = 0):String
        {
            return SharedObjectFlushStatus.FLUSHED;
        }

        /** Removes the data. */
        public function clear():void
        {
            _data = {};
        }
    }
}
