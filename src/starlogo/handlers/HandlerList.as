package starlogo.handlers
{
    /**
     * The handlers that a game has added for just two breeds, one as the collider and one as the collidee. They are in the order in which they were
     * added.
     *
     * @private
     */
    public final class HandlerList
    {
        /** What a frame calls for a first and a second agent of these breeds. It is null if none have met since the handlers changed. */
        public var pairHandlers:PairHandlers = null;

        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // The list begins with this number of removed handlers, and has no others. They stay until the next frame makes the list anew, because each splice
        // at the beginning of a long list would move all others.
        private var _removedCount:int = 0;

        /** Adds a handler. */
        public function add(handler:CollisionHandler):void
        {
            _handlers.push(handler);
        }

        /**
         * Removes the handler with a function that was added first. It compares one function after the other, because a function has no hash in
         * ActionScript.
         *
         * @param phases the phases that count: a sum
         * @return whether it was there
         */
        public function remove(callback:Function, phases:int):Boolean
        {
            for (var i:int = _removedCount; i < _handlers.length; i++)
            {
                var handler:CollisionHandler = _handlers[i];
                if (handler.callback == callback && (handler.phase & phases) != 0)
                {
                    handler.isRemoved = true;
                    if (i == _removedCount)
                    {
                        _removedCount++;
                    }
                    else
                    {
                        _handlers.splice(i, 1);
                    }
                    return true;
                }
            }
            return false;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for each (var handler:CollisionHandler in _handlers)
            {
                handler.isRemoved = true;
            }
            _handlers.length = _removedCount = 0;
        }

        /**
         * Appends the handlers to a list.
         *
         * @param end the revision before which handlers were added that count
         */
        public function appendTo(list:Vector.<CollisionHandler>, end:int):void
        {
            for (var i:int = _removedCount; i < _handlers.length && _handlers[i].addedAt < end; i++)
            {
                list.push(_handlers[i]);
            }
        }
    }
}
