package flash.display
{
    import flash.events.EventDispatcher;
    import standin.Machine;

    /** With what the program was started. */
    public class LoaderInfo extends EventDispatcher
    {
        /** The main class's. */
        public static const ofMain:LoaderInfo = new LoaderInfo();

        public function get parameters():Object
        {
            return Machine.parameters;
        }

        public function get url():String
        {
            return "";
        }
    }
}
