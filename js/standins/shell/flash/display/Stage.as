package flash.display
{
    /** The stage, of which nothing is seen. */
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
