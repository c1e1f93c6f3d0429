package flash.text
{
    /** The format of a text field. It has no effect. */
    public class TextFormat
    {
        public var align:String;

        public function TextFormat(font:String = null, size:Object = null, color:Object = null)
        {
        }
    }
}
