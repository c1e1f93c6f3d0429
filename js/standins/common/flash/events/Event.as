package flash.events
{
    import standin.Machine;

    /** An event and its target. It is only sent to its target and does not travel further. */
    public class Event
    {
        public static const ADDED_TO_STAGE:String = "addedToStage";
        public static const CANCEL:String = "cancel";
        public static const COMPLETE:String = "complete";
        public static const ENTER_FRAME:String = "enterFrame";
        public static const REMOVED_FROM_STAGE:String = "removedFromStage";
        public static const RESIZE:String = "resize";

        private var _type:String;
        private var _bubbles:Boolean;
        private var _cancelable:Boolean;
        private var _target:Object = null;
        private var _isStopped:Boolean = false;
        private var _isPrevented:Boolean = false;

        public function Event(type:String, bubbles:Boolean = false, cancelable:Boolean = false)
        {
            _type = type;
            _bubbles = bubbles;
            _cancelable = cancelable;
        }

        public function get type():String
        {
            return _type;
        }

        public function get bubbles():Boolean
        {
            return _bubbles;
        }

        public function get cancelable():Boolean
        {
            return _cancelable;
        }

        /** The object that sent the event; null before the event is dispatched to a listener. */
        public function get target():Object
        {
            return _target;
        }

        public function get currentTarget():Object
        {
            return _target;
        }

        /** Always 2, because an event is only at its target. */
        public function get eventPhase():uint
        {
            return 2;
        }

        /** A copy of the event, for another dispatch. Subclasses override it. */
        public function clone():Event
        {
            return new Event(_type, _bubbles, _cancelable);
        }

        /** Does nothing: an event is only sent to its target. */
        public function stopPropagation():void
        {
        }

        /** Keeps the event from the remaining listeners. */
        public function stopImmediatePropagation():void
        {
            _isStopped = true;
        }

        /** Makes dispatchEvent return false, if the event can be cancelled. */
        public function preventDefault():void
        {
            _isPrevented = _isPrevented || _cancelable;
        }

        public function isDefaultPrevented():Boolean
        {
            return _isPrevented;
        }

        /** [Class name=value name="text" ...], with the given properties. */
        public function formatToString(className:String, ...properties):String
        {
            var text:String = "[" + className;
            for each (var name:String in properties)
            {
                var value:* = this[name];
                text += " " + name + "=" + (value is String ? "\"" + value + "\"" : value);
            }
            return text + "]";
        }

        public function toString():String
        {
            return formatToString(Machine.className(this).split("::").pop(), "type", "bubbles", "cancelable", "eventPhase");
        }

        internal function arrive(target:Object):void
        {
            _target = target;
        }

        internal function get isStopped():Boolean
        {
            return _isStopped;
        }
    }
}
