package headless
{
    import flash.external.ExternalInterface;
    import flash.system.Capabilities;
    import flash.utils.getTimer;

    /**
     * What a document class tells the headless runner (test/headless): files to write, and that it is done.
     * In a browser page or a player without the runner nothing happens.
     */
    public final class Host
    {
        /**
         * Hands a text file to the runner, which puts it into its output folder.
         *
         * @param file a path below that folder
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
         * The player's memory in bytes, from outside: System.totalMemory is a constant in Ruffle. It grows when the
         * player needs more and never shrinks. -1 where the runner is not there.
         */
        public static function get memory():Number
        {
            var bytes:* = tell("headless.memory");
            return bytes == null ? -1 : bytes;
        }

        /**
         * Has garbage collected, so that <code>memory</code> tells what is in use. Players do that by themselves between frames;
         * in Adobe's shell, where frames follow one another at once, the collector may fall behind.
         */
        public static function collect():void
        {
            tell("headless.collect");
        }

        /** Milliseconds from some moment on, with fractions: getTimer counts whole ones. That where the runner is not there. */
        public static function get now():Number
        {
            var ms:* = tell("headless.now");
            return ms == null ? getTimer() : ms;
        }

        /** What the program runs in, and which version of it. */
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
