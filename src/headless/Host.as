package headless
{
    import flash.external.ExternalInterface;
    import flash.system.Capabilities;
    import flash.utils.getTimer;

    /**
     * Lets a document class talk to the headless runner (build/headless): it writes files and ends the run. In a browser page, or in a
     * player without the runner, its methods do nothing.
     */
    public final class Host
    {
        /**
         * Writes a text file to the runner's output folder.
         *
         * @param file a path in that folder
         * @param text the whole content
         */
        public static function writeFile(file:String, text:String):void
        {
            tell("headless.writeFile", file, text);
        }

        /**
         * Ends the run.
         *
         * @param status the exit status of the runner: 0 for success
         */
        public static function exit(status:int):void
        {
            tell("headless.exit", status);
        }

        /**
         * The player's memory in bytes, as measured by the runner, because System.totalMemory is a constant in Ruffle. It grows when the
         * player needs more, and never shrinks. -1 without the runner.
         */
        public static function get memory():Number
        {
            var bytes:* = tell("headless.memory");
            return bytes == null ? -1 : bytes;
        }

        /**
         * Runs the garbage collector, so that <code>memory</code> is the memory in use. Players collect between frames by themselves. In
         * Adobe's shell frames follow one another at once, so its collector may fall behind.
         */
        public static function collect():void
        {
            tell("headless.collect");
        }

        /** Milliseconds since some fixed moment, with fractions. Without the runner it is getTimer, which counts whole milliseconds. */
        public static function get now():Number
        {
            var ms:* = tell("headless.now");
            return ms == null ? getTimer() : ms;
        }

        /** Milliseconds of the processor that the program has used. Only Node tells them; elsewhere it is <code>now</code>. */
        public static function get processorMs():Number
        {
            var ms:* = tell("headless.processorMs");
            return ms == null ? now : ms;
        }

        /** The most memory in bytes that the program has had at once. Only Node tells it; elsewhere it is -1. */
        public static function get mostMemory():Number
        {
            var bytes:* = tell("headless.mostMemory");
            return bytes == null ? -1 : bytes;
        }

        /** The name and version of the player or machine that runs the program. */
        public static function get player():String
        {
            return tell("headless.player") || Capabilities.version;
        }

        private static function tell(name:String, ...args):*
        {
            if (!ExternalInterface.available)
            {
                return null;
            }
            return ExternalInterface.call.apply(null, [name].concat(args));
        }
    }
}
