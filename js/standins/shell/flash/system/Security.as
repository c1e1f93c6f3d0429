package flash.system
{
    /** Everything may be loaded. */
    public final class Security
    {
        public static function loadPolicyFile(url:String):void
        {
        }
    }
}
