package headless
{
    import flash.external.ExternalInterface;

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

        private static function tell(name:String, ...args):void
        {
            if (ExternalInterface.available)
            {
                ExternalInterface.call.apply(null, [name].concat(args));
            }
        }
    }
}
