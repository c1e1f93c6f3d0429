package flash.text
{
    /** On which side a text field grows. */
    public final class TextFieldAutoSize
    {
        public static const CENTER:String = "center";
        public static const LEFT:String = "left";
        public static const NONE:String = "none";
        public static const RIGHT:String = "right";
    }
}
