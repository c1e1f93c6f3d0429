package flash.text
{
    /** On which side a text field grows. */
    public final class TextFieldAutoSize
    {
        public static const LEFT:String = "left";
    }
}
