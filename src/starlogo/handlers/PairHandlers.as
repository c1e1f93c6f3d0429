package starlogo.handlers
{
    /**
     * The handlers of a pair of breeds: the ones that a game has added for just these two, and all that a frame calls for the two. The latter are in
     * the order of their calls. First come the handlers whose collider is the first agent, then the handlers whose collider is the second agent. In
     * each half, handlers for starts come first, and handlers for ends come last.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** For find(): handlers of all kinds. */
        public static const ANY_KIND:int = -1;

        /** The number of the first agent's breed. */
        public var breed:int;

        /** The number of the second agent's breed. */
        public var otherBreed:int;

        /**
         * The handlers that were added for just these two breeds, the first one as the collider, in the order in which they were added. Removed
         * ones that the frame knows may be among them.
         */
        public var added:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // Handlers before this place among them were removed. How many handlers were removed since the list was last made shorter.
        private var _firstKept:int = 0;
        private var _removedCount:int = 0;

        /** How many handlers the HandlerTable knew when the members below were set; -1 at first. */
        public var knownCount:int = -1;

        /** The handlers of all kinds. */
        public var handlers:Vector.<CollisionHandler>;

        /** The number of handlers whose collider is the first agent. */
        public var forwardCount:int;

        /** Whether any handler takes the contact of a touch. */
        public var needsContacts:Boolean;

        /** Whether any handler is for starts or ends of touches. */
        public var tracksTouches:Boolean;

        public function PairHandlers(breed:int, otherBreed:int)
        {
            this.breed = breed;
            this.otherBreed = otherBreed;
        }

        /**
         * Sets what is called for the two.
         *
         * @param forward the handlers whose collider is the first agent
         * @param back the handlers whose collider is the second agent
         */
        public function setHandlers(forward:Vector.<CollisionHandler>, back:Vector.<CollisionHandler>):void
        {
            handlers = forward.concat(back);
            forwardCount = forward.length;
            needsContacts = tracksTouches = false;
            for each (var handler:CollisionHandler in handlers)
            {
                needsContacts ||= handler.needsContact;
                tracksTouches ||= handler.kind != CollisionHandler.COLLISION;
            }
        }

        /**
         * Finds the added handler with a function that was added first and is not removed. Null if there is none. It compares one function after the
         * other, because a function has no hash in ActionScript.
         *
         * @param kind of handler, or ANY_KIND
         */
        public function find(callback:Function, kind:int):CollisionHandler
        {
            for (var i:int = _firstKept; i < added.length; i++)
            {
                var candidate:CollisionHandler = added[i];
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
            if (2 * _removedCount > added.length)
            {
                dropRemoved(knownCount);
            }
            while (_firstKept < added.length && added[_firstKept].isRemoved)
            {
                _firstKept++;
            }
        }

        /** Removes all handlers that were added, as remove() does. */
        public function removeAll(knownCount:int):void
        {
            for each (var handler:CollisionHandler in added)
            {
                handler.isRemoved = true;
            }
            dropRemoved(knownCount);
            _firstKept = added.length;
        }

        // Takes removed handlers out of the list, except for those that the frame knows.
        private function dropRemoved(knownCount:int):void
        {
            added = added.filter(function(one:CollisionHandler, index:int, all:Vector.<CollisionHandler>):Boolean
                {
                    return !one.isRemoved || one.order < knownCount;
                });
            _removedCount = 0;
            _firstKept = 0;
        }
    }
}
