package starlogo.handlers
{
    /**
     * What a frame calls for a pair of breeds. First come the handlers whose collider is the first agent, then those
     * whose collider is the second agent. In each half, handlers for starts come first, and handlers for ends come last.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** The handlers of all phases, in the order of their calls. */
        public var handlers:Vector.<CollisionHandler>;

        /** The index at which the handlers begin whose collider is the second agent. */
        public var splitIndex:int;

        /** The phases of the handlers that take the contact of a touch: a sum of CollisionHandler.START and EVERY_FRAME. */
        public var contactPhases:int = 0;

        /** The phases of the handlers: a sum of CollisionHandler.START and so on. */
        public var phases:int = 0;

        /**
         * @param ofFirst the handlers whose collider is the first agent, in any order
         * @param ofSecond the handlers whose collider is the second agent, in any order
         */
        public function PairHandlers(ofFirst:Vector.<CollisionHandler>, ofSecond:Vector.<CollisionHandler>)
        {
            handlers = ofFirst.sort(compare).concat(ofSecond.sort(compare));
            splitIndex = ofFirst.length;
            for each (var handler:CollisionHandler in handlers)
            {
                phases |= handler.phase;
                contactPhases |= handler.contactPhase;
            }
        }

        /** Whether a handler is for starts or ends, so that touches have to be tracked. */
        public function get tracksTouches():Boolean
        {
            return (phases & ~CollisionHandler.EVERY_FRAME) != 0;
        }

        // By phase, and then by the order in which they were added.
        private static function compare(a:CollisionHandler, b:CollisionHandler):Number
        {
            return a.phase == b.phase ? a.addedAt - b.addedAt : a.phase - b.phase;
        }
    }
}
