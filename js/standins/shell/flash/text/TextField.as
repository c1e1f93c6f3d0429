package flash.text
{
    import flash.display.InteractiveObject;

    /** A text that nobody sees. */
    public class TextField extends InteractiveObject
    {
        public var text:String = "";
        public var autoSize:String = TextFieldAutoSize.NONE;
        public var defaultTextFormat:TextFormat = new TextFormat();
        public var selectable:Boolean = true;
        public var multiline:Boolean = false;
        public var wordWrap:Boolean = false;
        public var textColor:uint = 0;
        public var background:Boolean = false;
        public var backgroundColor:uint = 0xffffff;
        public var border:Boolean = false;

        public function appendText(newText:String):void
        {
            text += newText;
        }

        public function setTextFormat(format:TextFormat, beginIndex:int = -1, endIndex:int = -1):void
        {
        }
    }
}
