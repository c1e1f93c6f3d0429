package flash.text
{
    /** How text would look. */
    public class TextFormat
    {
        public var align:String;

        public function TextFormat(font:String = null, size:Object = null, color:Object = null)
        {
        }
    }
}
