package flash.events
{
    import standin.Machine;

    /**
     * Sends events to listeners. Listeners of higher priority are called first, those of the same priority in the order in which they were
     * added. If a listener is added or removed during a dispatch, this takes effect with the next event. A listener that is called once never
     * runs twice, not even in a dispatch inside of another.
     *
     * <p>Listeners of the capture phase are kept but never called. All listeners are kept until they are removed, also those with weak
     * references. If a listener throws, the others are still called, and the error is reported as uncaught. An error event without a
     * listener is reported as uncaught too. Ruffle reports neither.</p>
     */
    public class EventDispatcher implements IEventDispatcher
    {
        private var _target:IEventDispatcher;
        private var _listeners:Object = {};

        /** @param target the target of the events; null is this dispatcher */
        public function EventDispatcher(target:IEventDispatcher = null)
        {
            _target = target;
        }

        /**
         * Adds a listener. One that is already added stays with its old priority.
         *
         * @throws TypeError if the type or the listener is null
         */
        public function addEventListener(type:String, listener:Function, useCapture:Boolean = false, priority:int = 0,
                useWeakReference:Boolean = false):void
        {
            check(type, "type");
            check(listener, "listener");
            if (recordOf(type, listener, useCapture) != null)
            {
                return;
            }
            var all:Array = listenersTo(type);
            var place:int = 0;
            while (place < all.length && all[place].priority >= priority)
            {
                place++;
            }
            var added:Listener = new Listener(listener, useCapture, priority);
            _listeners[type] = all.slice(0, place).concat([added], all.slice(place)); // a running dispatch keeps its list
            if (type == Event.ENTER_FRAME && Machine.frameListeners.indexOf(this) < 0)
            {
                Machine.frameListeners.push(this);
            }
        }

        /** @throws TypeError if the type or the listener is null */
        public function removeEventListener(type:String, listener:Function, useCapture:Boolean = false):void
        {
            check(type, "type");
            check(listener, "listener");
            removeRecord(type, recordOf(type, listener, useCapture));
        }

        public function hasEventListener(type:String):Boolean
        {
            return listenersTo(type).length > 0;
        }

        public function willTrigger(type:String):Boolean
        {
            return hasEventListener(type);
        }

        /**
         * Calls the listeners with the event. If the event was dispatched before, they get its clone.
         *
         * @return false if a listener prevented the default
         */
        public function dispatchEvent(event:Event):Boolean
        {
            if (event.target != null)
            {
                event = event.clone();
            }
            var isHeard:Boolean = false;
            for each (var listener:Listener in listenersTo(event.type))
            {
                var call:Function = listener.call;
                if (listener.isCapturing || event.isStopped || call == null)
                {
                    continue;
                }
                isHeard = true;
                if (listener.isOnce)
                {
                    removeRecord(event.type, listener);
                    listener.call = null;
                }
                event.arrive(_target == null ? this : _target);
                try
                {
                    call(event);
                }
                catch (error:*)
                {
                    Machine.uncaught(error);
                }
            }
            if (!isHeard && event is ErrorEvent)
            {
                Machine.uncaught(Machine.unheard(event.type, ErrorEvent(event).text));
            }
            return !event.isDefaultPrevented();
        }

        public function toString():String
        {
            return "[object " + Machine.className(this).split("::").pop() + "]";
        }

        private function listenersTo(type:String):Array
        {
            return _listeners.hasOwnProperty(type) ? _listeners[type] : [];
        }

        // Removes a listener, if it is still there: not one that the same function has become since.
        private function removeRecord(type:String, listener:Listener):void
        {
            var all:Array = listenersTo(type);
            var place:int = all.indexOf(listener);
            if (place < 0)
            {
                return;
            }
            _listeners[type] = all.slice(0, place).concat(all.slice(place + 1));
            if (type == Event.ENTER_FRAME && all.length == 1)
            {
                Machine.frameListeners.splice(Machine.frameListeners.indexOf(this), 1);
            }
        }

        private function recordOf(type:String, call:Function, isCapturing:Boolean):Listener
        {
            for each (var listener:Listener in listenersTo(type))
            {
                if (listener.call == call && listener.isCapturing == isCapturing)
                {
                    return listener;
                }
            }
            return null;
        }

        private static function check(value:Object, name:String):void
        {
            if (value == null)
            {
                throw new TypeError("Error #2007: Parameter " + name + " must be non-null.");
            }
        }
    }
}
