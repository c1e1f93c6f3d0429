package flash.display
{
    /** A stage of a fixed size. */
    public class Stage extends DisplayObjectContainer
    {
        public var scaleMode:String = StageScaleMode.SHOW_ALL;
        public var align:String = "";
        public var frameRate:Number = 24;
        public var quality:String = "HIGH";
        public var focus:InteractiveObject = null;

        override public function get stage():Stage
        {
            return this;
        }

        public function get stageWidth():int
        {
            return 960;
        }

        public function get stageHeight():int
        {
            return 640;
        }
    }
}
