package flash.system
{
    /** The shell has one itself, which knows less, and takes its own: this is for the compiler. */
    public final class Capabilities
    {
        public static function get version():String
        {
            return null;
        }
    }
}
