package flash.text
{
    import flash.display.DisplayObject;

    /** A text field that is not drawn. Its text is not measured either. */
    public class TextField extends DisplayObject
    {
        public var text:String = "";
        public var autoSize:String = "";
        public var defaultTextFormat:TextFormat = null;
        public var selectable:Boolean = true;
        public var textWidth:Number = 0;
        public var textHeight:Number = 0;

        public function appendText(newText:String):void
        {
            text += newText;
        }
    }
}
