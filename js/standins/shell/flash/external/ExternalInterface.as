package flash.external
{
    import standin.Machine;

    /** Passes the calls of headless.Host on. There are no other functions to call. */
    public final class ExternalInterface
    {
        public static function get available():Boolean
        {
            return true;
        }

        public static function call(functionName:String, ...args):*
        {
            switch (functionName)
            {
                case "headless.now":
                    return Machine.now();
                case "headless.memory":
                    return Machine.memory();
                case "headless.collect":
                    return Machine.collect();
                case "headless.player":
                    return Machine.player;
                case "headless.writeFile":
                    return Machine.writeFile(args[0], args[1]);
                case "headless.exit":
                    return Machine.exit(args[0]);
                default:
                    return null;
            }
        }
    }
}
