package flash.events
{
    import standin.Machine;

    /**
     * Sends events to listeners. Listeners of higher priority are called first, those of the same priority in the order in which they were
     * added. If a listener is added or removed during a dispatch, this takes effect with the next event. A listener that is called once never
     * runs twice, not even in a dispatch inside of another.
     *
     * <p>Events have no phases here, so a listener of the capture phase is as any other. All listeners are kept until they are removed, also those
     * with weak references. If a listener throws, the others are still called, and the error is reported as uncaught. An error event without a
     * listener is reported as uncaught too. Ruffle reports neither.</p>
     */
    public class EventDispatcher implements IEventDispatcher
    {
        private var _target:IEventDispatcher;

        // of all types; those of higher priority come first
        private var _listeners:Array = [];

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
            if (recordOf(type, listener) != null)
            {
                return;
            }
            if (type == Event.ENTER_FRAME && !hasEventListener(type))
            {
                Machine.addFrameListener(this);
            }
            var place:int = 0;
            while (place < _listeners.length && _listeners[place].priority >= priority)
            {
                place++;
            }
            _listeners.splice(place, 0, new Listener(type, listener, priority));
        }

        /** @throws TypeError if the type or the listener is null */
        public function removeEventListener(type:String, listener:Function, useCapture:Boolean = false):void
        {
            check(type, "type");
            check(listener, "listener");
            removeRecord(recordOf(type, listener));
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
            var isHandled:Boolean = false;
            for each (var listener:Listener in listenersTo(event.type))
            {
                var call:Function = listener.call;
                if (event.isStopped || call == null)
                {
                    continue;
                }
                isHandled = true;
                if (listener.isOnce)
                {
                    removeRecord(listener);
                    listener.call = null;
                }
                event.arrive(_target == null ? this : _target);
                try
                {
                    call(event);
                }
                catch (error:*)
                {
                    Machine.reportError(error);
                }
            }
            if (!isHandled && event is ErrorEvent)
            {
                Machine.reportError(Machine.unhandledEvent(event.type, ErrorEvent(event).text));
            }
            return !event.isDefaultPrevented();
        }

        public function toString():String
        {
            return "[object " + Machine.className(this).split("::").pop() + "]";
        }

        // A list of its own: a running dispatch keeps it.
        private function listenersTo(type:String):Array
        {
            return _listeners.filter(function(listener:Listener, ...others):Boolean
                {
                    return listener.type == type;
                });
        }

        // Removes a listener, if it is still there: not one that the same function has become since.
        private function removeRecord(listener:Listener):void
        {
            var place:int = _listeners.indexOf(listener);
            if (place < 0)
            {
                return;
            }
            _listeners.splice(place, 1);
            if (listener.type == Event.ENTER_FRAME && !hasEventListener(listener.type))
            {
                Machine.removeFrameListener(this);
            }
        }

        private function recordOf(type:String, call:Function):Listener
        {
            for each (var listener:Listener in listenersTo(type))
            {
                if (listener.call == call)
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
