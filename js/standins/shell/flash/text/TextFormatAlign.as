package flash.text
{
    /** The side on which lines begin. */
    public final class TextFormatAlign
    {
        public static const LEFT:String = "left";
        public static const RIGHT:String = "right";
    }
}
