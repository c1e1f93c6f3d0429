package flash.text
{
    /** On which side lines begin. */
    public final class TextFormatAlign
    {
        public static const LEFT:String = "left";
        public static const RIGHT:String = "right";
    }
}
