package flash.text
{
    /** On which side lines begin. */
    public final class TextFormatAlign
    {
        public static const CENTER:String = "center";
        public static const JUSTIFY:String = "justify";
        public static const LEFT:String = "left";
        public static const RIGHT:String = "right";
    }
}
