package flash.display
{
    import flash.events.Event;
    import flash.events.EventDispatcher;

    /** What would be shown: its place and parent. */
    public class DisplayObject extends EventDispatcher
    {
        /** The stage, to the main class also before it is on it. */
        public static var stageOfMain:Stage = null;

        public var x:Number = 0;
        public var y:Number = 0;
        public var width:Number = 0;
        public var height:Number = 0;
        public var visible:Boolean = true;
        public var cacheAsBitmap:Boolean = false;

        internal var container:DisplayObjectContainer = null;

        public function get parent():DisplayObjectContainer
        {
            return container;
        }

        public function get stage():Stage
        {
            return container == null ? stageOfMain : container.stage;
        }

        public function get loaderInfo():LoaderInfo
        {
            return LoaderInfo.ofMain;
        }

        /** Tells this and whatever is in it. */
        internal function tell(type:String):void
        {
            dispatchEvent(new Event(type));
        }
    }
}
