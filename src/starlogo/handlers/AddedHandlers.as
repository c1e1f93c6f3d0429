package starlogo.handlers
{
    /**
     * The handlers that a game has added for two breeds, the first one as the collider.
     *
     * @private
     */
    public final class AddedHandlers
    {
        /** For find(): handlers of all kinds. */
        public static const ANY_KIND:int = -1;

        /** The handlers, in the order in which they were added. Removed ones that the frame knows may be among them. */
        public var list:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // Handlers before this place in the list were removed. How many handlers were removed since the list was made shorter.
        private var _firstKept:int = 0;
        private var _removedCount:int = 0;

        /**
         * Finds the handler with a function that was added first and is not removed. Null if there is none. It compares one function after the
         * other, because a function has no hash in ActionScript.
         *
         * @param kind of handler, or ANY_KIND
         */
        public function find(callback:Function, kind:int):CollisionHandler
        {
            for (var i:int = _firstKept; i < list.length; i++)
            {
                var candidate:CollisionHandler = list[i];
                if (candidate.callback == callback && !candidate.isRemoved && (kind == ANY_KIND || candidate.kind == kind))
                {
                    return candidate;
                }
            }
            return null;
        }

        /**
         * Removes a handler. It stays in the list if the frame knows it, because a frame keeps its handlers up to its end.
         *
         * @param knownCount the frame knows the handlers whose order is less than this
         */
        public function remove(handler:CollisionHandler, knownCount:int):void
        {
            handler.isRemoved = true;
            _removedCount++;
            if (2 * _removedCount > list.length)
            {
                dropRemoved(knownCount);
            }
            while (_firstKept < list.length && list[_firstKept].isRemoved)
            {
                _firstKept++;
            }
        }

        /** Removes all handlers, as remove() does. */
        public function removeAll(knownCount:int):void
        {
            for each (var handler:CollisionHandler in list)
            {
                handler.isRemoved = true;
            }
            dropRemoved(knownCount);
            _firstKept = list.length;
        }

        // Takes removed handlers out of the list, except for those that the frame knows.
        private function dropRemoved(knownCount:int):void
        {
            list = list.filter(function(one:CollisionHandler, index:int, all:Vector.<CollisionHandler>):Boolean
                {
                    return !one.isRemoved || one.order < knownCount;
                });
            _removedCount = 0;
            _firstKept = 0;
        }
    }
}
