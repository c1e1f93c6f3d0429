package standin
{
    /**
     * What the stand-ins need of the machine beneath: functions that whoever starts the program sets before anything else.
     *
     * <p>The first group is for every machine. The second is what Adobe's shell gives beyond it, for tests and benchmarks.</p>
     */
    public final class Machine
    {
        /** <code>():Number</code>: milliseconds from some moment on, with fractions. */
        public static var now:Function;

        /**
         * <code>():int</code>: whole milliseconds; null is those of <code>now</code>. Adobe's VM puts each Number that a Function
         * returns on the heap, and no int.
         */
        public static var timer:Function = null;

        /** <code>(callback:Function, ms:Number):uint</code>: calls back once, when so many milliseconds are over. */
        public static var setTimeout:Function;

        /** <code>(id:uint):void</code>: takes back what setTimeout promised. */
        public static var clearTimeout:Function;

        /** <code>(error:*):void</code>: told of what a listener threw, and of error events that nobody listens for. */
        public static var uncaught:Function;

        /** The error of an error event that nothing listens for. */
        public static function unheard(type:String, text:String):Error
        {
            return new Error("Error #2044: Unhandled " + type + ":. text=" + text);
        }

        /** <code>(url:String):ByteArray</code>: a file's bytes; null where there is none. */
        public static var readFile:Function;

        /** <code>(file:String, text:String):void</code>: writes a file below the folder for what the run puts out. */
        public static var writeFile:Function;

        /** <code>(status:int):void</code>: ends the program after this frame. */
        public static var exit:Function;

        /** <code>():Number</code>: bytes in use. */
        public static var memory:Function;

        /** <code>():void</code>: collects garbage. */
        public static var collect:Function;

        /** <code>(value:*):String</code>: its class's name, as getQualifiedClassName. */
        public static var className:Function;

        /** <code>(name:String):Object</code>: the class of that name, as getDefinitionByName. */
        public static var definition:Function;

        /** <code>(value:*):XML</code>: as describeType. */
        public static var describe:Function;

        /** What it is, and which version of it. */
        public static var player:String;

        /** What the document class finds in loaderInfo.parameters. */
        public static var parameters:Object = {};

        /** Who listens for frames: EventDispatchers, each once. */
        public static var frameListeners:Array = [];
    }
}
