package flash.system
{
    /** For the compiler only. The shell uses its own class, which knows less. */
    public final class Capabilities
    {
        public static function get version():String
        {
            return null;
        }
    }
}
