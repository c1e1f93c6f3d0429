package support
{
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLLoaderDataFormat;
    import flash.net.URLRequest;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.internals.AssumptionViolatedException;

    /** The files that tests read, loaded before the first test runs. */
    public final class Fixtures
    {
        private static var sFiles:Object = {};
        private static var sPending:Array;
        private static var sComplete:Function;

        /** The addresses that classes list in their public static FIXTURES. */
        public static function listOf(classes:Array):Array
        {
            var addresses:Array = [];
            for each (var reader:Class in classes)
            {
                if ("FIXTURES" in reader)
                {
                    addresses = addresses.concat(reader["FIXTURES"]);
                }
            }
            return addresses;
        }

        /**
         * Loads the files one after the other; one that is not there is left out.
         *
         * @param addresses absolute paths on the server that the SWF comes from
         * @param complete called without arguments when all are loaded
         */
        public static function load(addresses:Array, complete:Function):void
        {
            sPending = addresses.concat();
            sComplete = complete;
            loadNext();
        }

        /** Whether a file was there. */
        public static function has(address:String):Boolean
        {
            return sFiles.hasOwnProperty(address);
        }

        /**
         * Skips the test that calls it where a file is not there.
         *
         * @param address the file
         * @param reason why that may be
         */
        public static function assume(address:String, reason:String):void
        {
            if (!has(address))
            {
                trace("  " + reason);
                throw new AssumptionViolatedException(reason + ": " + address);
            }
        }

        /** A file's bytes, little-endian, from its first. */
        public static function bytes(address:String):ByteArray
        {
            if (!has(address))
            {
                throw new ArgumentError("no such fixture (is it in the test's FIXTURES, and served?): " + address);
            }
            var content:ByteArray = sFiles[address];
            content.endian = Endian.LITTLE_ENDIAN;
            content.position = 0;
            return content;
        }

        /** A file's text. */
        public static function text(address:String):String
        {
            var content:ByteArray = bytes(address);
            return content.readUTFBytes(content.length);
        }

        private static function loadNext():void
        {
            if (sPending.length == 0)
            {
                sComplete();
                return;
            }
            var address:String = sPending.shift();
            if (has(address))
            {
                loadNext();
                return;
            }
            var loader:URLLoader = new URLLoader();
            loader.dataFormat = URLLoaderDataFormat.BINARY;
            loader.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    sFiles[address] = loader.data;
                    loadNext();
                });
            loader.addEventListener(IOErrorEvent.IO_ERROR, function(event:Event):void
                {
                    loadNext();
                });
            loader.load(new URLRequest(address));
        }
    }
}
