package flash.text
{
    /** The side on which a text field grows. */
    public final class TextFieldAutoSize
    {
        public static const LEFT:String = "left";
    }
}
