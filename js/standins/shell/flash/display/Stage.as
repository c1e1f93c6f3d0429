package flash.display
{
    /** The stage. It is not drawn. */
    public class Stage extends DisplayObjectContainer
    {
        public var scaleMode:String = "";
        public var align:String = "";
        public var frameRate:Number = 24;
        public var stageWidth:int = 960;

        override public function get stage():Stage
        {
            return this;
        }
    }
}
