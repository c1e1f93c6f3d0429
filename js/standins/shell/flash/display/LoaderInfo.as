package flash.display
{
    import standin.Machine;

    /** The program's parameters. */
    public class LoaderInfo
    {
        /** The LoaderInfo of the main class. */
        public static const ofMain:LoaderInfo = new LoaderInfo();

        public function get parameters():Object
        {
            return Machine.parameters;
        }
    }
}
