package flash.text
{
    import flash.display.DisplayObject;

    /** A text that nobody sees. */
    public class TextField extends DisplayObject
    {
        public var text:String = "";
        public var autoSize:String = "";
        public var defaultTextFormat:TextFormat = null;
        public var selectable:Boolean = true;

        public function appendText(newText:String):void
        {
            text += newText;
        }
    }
}
