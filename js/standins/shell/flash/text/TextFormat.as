package flash.text
{
    /** How text would look. */
    public class TextFormat
    {
        public var font:String;
        public var size:Object;
        public var color:Object;
        public var bold:Object;
        public var italic:Object;
        public var align:String;
        public var leading:Object;
        public var tabStops:Array;

        public function TextFormat(font:String = null, size:Object = null, color:Object = null, bold:Object = null, italic:Object = null,
                underline:Object = null, url:String = null, target:String = null, align:String = null)
        {
            this.font = font;
            this.size = size;
            this.color = color;
            this.bold = bold;
            this.italic = italic;
            this.align = align;
        }
    }
}
