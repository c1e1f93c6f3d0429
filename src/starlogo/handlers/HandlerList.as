package starlogo.handlers
{
    /**
     * The handlers that a game has added for just two breeds, the first one as the collider. They are in the order in which they were added.
     *
     * @private
     */
    public final class HandlerList
    {
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // How many of the first handlers are removed. The others are not.
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
         * @param kinds the kinds that count: a sum
         * @return whether it was there
         */
        public function remove(callback:Function, kinds:int):Boolean
        {
            for (var i:int = _removedCount; i < _handlers.length; i++)
            {
                var handler:CollisionHandler = _handlers[i];
                if (handler.callback == callback && (handler.kind & kinds) != 0)
                {
                    handler.isRemoved = true;
                    removeAt(i);
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
         * @param end only handlers whose serial number is less
         */
        public function appendTo(list:Vector.<CollisionHandler>, end:int):void
        {
            for (var i:int = _removedCount; i < _handlers.length && _handlers[i].serial < end; i++)
            {
                list.push(_handlers[i]);
            }
        }

        // If the first handler is removed, the others stay in their places until more than half of the places are free. So it takes no longer to remove many
        // handlers than to add them.
        private function removeAt(index:int):void
        {
            if (index > _removedCount)
            {
                _handlers.splice(index, 1);
            }
            else
            {
                _removedCount++;
            }
            if (2 * _removedCount > _handlers.length)
            {
                _handlers.splice(0, _removedCount);
                _removedCount = 0;
            }
        }
    }
}
