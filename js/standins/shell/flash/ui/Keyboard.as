package flash.ui
{
    /** Codes of keys. */
    public final class Keyboard
    {
        public static const BACKQUOTE:uint = 192;
        public static const ENTER:uint = 13;
        public static const ESCAPE:uint = 27;
        public static const SPACE:uint = 32;
        public static const F1:uint = 112;
        public static const F2:uint = 113;
        public static const F3:uint = 114;
        public static const F4:uint = 115;
        public static const F5:uint = 116;
        public static const F6:uint = 117;
        public static const F7:uint = 118;
        public static const F8:uint = 119;
        public static const F9:uint = 120;
        public static const F10:uint = 121;
        public static const F11:uint = 122;
        public static const F12:uint = 123;
    }
}
