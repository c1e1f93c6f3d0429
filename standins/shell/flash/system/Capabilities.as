package flash.system
{
    /** On what the program runs. */
    public final class Capabilities
    {
        /** Instead of the player's version: what this is. */
        public static function get version():String
        {
            return "Adobe's VM (avmshell)";
        }
    }
}
