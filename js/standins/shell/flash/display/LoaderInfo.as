package flash.display
{
    import standin.Machine;

    /** With what the program was started. */
    public class LoaderInfo
    {
        /** The main class's. */
        public static const ofMain:LoaderInfo = new LoaderInfo();

        public function get parameters():Object
        {
            return Machine.parameters;
        }
    }
}
