package standin
{
    /**
     * The stand-ins' access to the machine: functions that must be set before the program starts.
     *
     * <p>The first group is for every machine. Only Adobe's shell has the second group, for tests and benchmarks.</p>
     */
    public final class Machine
    {
        /** <code>():Number</code>: milliseconds since some fixed moment, with fractions. */
        public static var now:Function;

        /**
         * <code>():int</code>: whole milliseconds; null to use <code>now</code>. Adobe's VM allocates memory for each Number that a
         * Function returns, but not for an int.
         */
        public static var timer:Function = null;

        /** <code>(callback:Function, ms:Number):uint</code>: calls the function once, after this time. */
        public static var setTimeout:Function;

        /** <code>(id:uint):void</code>: cancels a setTimeout. */
        public static var clearTimeout:Function;

        /** <code>(error:*):void</code>: called with errors that listeners threw, and with error events without a listener. */
        public static var reportError:Function;

        /** The error for an error event without a listener. */
        public static function unhandledEvent(type:String, text:String):Error
        {
            return new Error("Error #2044: Unhandled " + type + ":. text=" + text);
        }

        /** <code>(url:String):ByteArray</code>: a file's bytes; null if there is no such file. */
        public static var readFile:Function;

        /** <code>(file:String, text:String):void</code>: writes a file to the run's output folder. */
        public static var writeFile:Function;

        /** <code>(status:int):void</code>: ends the program after this frame. */
        public static var exit:Function;

        /** <code>():Number</code>: bytes in use. */
        public static var memory:Function;

        /** <code>():void</code>: collects garbage. */
        public static var collect:Function;

        /** <code>(value:*):String</code>: the name of a value's class, as getQualifiedClassName. */
        public static var className:Function;

        /** <code>(name:String):Object</code>: the class with a name, as getDefinitionByName. */
        public static var definition:Function;

        /** <code>(value:*):XML</code>: a description, as describeType. */
        public static var describe:Function;

        /** The name and version of the machine. */
        public static var player:String;

        /** The content of the document class's loaderInfo.parameters. */
        public static var parameters:Object = {};

        /** The frame listeners: EventDispatchers, each once. */
        public static var frameListeners:Array = [];

        /** Sends frames to an EventDispatcher from now on. */
        public static function addFrameListener(dispatcher:Object):void
        {
            frameListeners.push(dispatcher);
        }

        /** Sends it no more frames. */
        public static function removeFrameListener(dispatcher:Object):void
        {
            frameListeners.splice(frameListeners.indexOf(dispatcher), 1);
        }
    }
}
