package flash.display
{
    import flash.events.Event;
    import flash.events.EventDispatcher;

    /** A display object with a place and a parent. It is not drawn. */
    public class DisplayObject extends EventDispatcher
    {
        /** The stage. The main class has it before it is on the stage. */
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

        /** Sends an event to this object and all objects in it. */
        internal function tell(type:String):void
        {
            dispatchEvent(new Event(type));
        }
    }
}
