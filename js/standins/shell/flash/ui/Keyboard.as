package flash.ui
{
    /** Key codes. */
    public final class Keyboard
    {
        public static const BACKQUOTE:uint = 192;
        public static const SPACE:uint = 32;
        public static const F2:uint = 113;
    }
}
