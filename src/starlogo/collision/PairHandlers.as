package starlogo.collision
{
    /** The handlers of a pair of breeds, both ways: whom the first one's collider calls, then whom the second one's does. */
    internal final class PairHandlers
    {
        /** Those of a frame in which the two touch, in the order of their calls. */
        public var handlers:Vector.<CollisionHandler>;

        /** So many at the beginning have the first agent for their collider, the rest the second. */
        public var forwardCount:int;

        /** Those of the first frame of a touch: of either collider's, those of its start before the others. */
        public var firstHandlers:Vector.<CollisionHandler>;

        /** So many of these have the first agent for their collider. */
        public var firstForwardCount:int;

        /** Those of the end of a touch. */
        public var endHandlers:Vector.<CollisionHandler>;

        /** So many of these have the first agent for their collider. */
        public var endForwardCount:int;

        /** Whether somebody asks when touches begin or end. */
        public var tracks:Boolean;

        /** Whether somebody asks for contacts. */
        public var takesContacts:Boolean;

        /**
         * @param forward those for which the first agent is the collider, of all kinds, or null
         * @param back those for which the second is, or null
         */
        public function PairHandlers(forward:Vector.<CollisionHandler>, back:Vector.<CollisionHandler>)
        {
            handlers = ofKind(forward, CollisionHandler.COLLISION);
            firstHandlers = ofKind(forward, CollisionHandler.START).concat(handlers);
            forwardCount = handlers.length;
            firstForwardCount = firstHandlers.length;
            var handlersBack:Vector.<CollisionHandler> = ofKind(back, CollisionHandler.COLLISION);
            handlers = handlers.concat(handlersBack);
            firstHandlers = firstHandlers.concat(ofKind(back, CollisionHandler.START), handlersBack);
            endHandlers = ofKind(forward, CollisionHandler.END);
            endForwardCount = endHandlers.length;
            endHandlers = endHandlers.concat(ofKind(back, CollisionHandler.END));
            tracks = firstHandlers.length > handlers.length || endHandlers.length > 0;
            for each (var handler:CollisionHandler in firstHandlers)
            {
                takesContacts = takesContacts || handler.takesContact;
            }
        }

        private static function ofKind(handlers:Vector.<CollisionHandler>, kind:int):Vector.<CollisionHandler>
        {
            var result:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var handler:CollisionHandler in handlers)
            {
                if (handler.kind == kind)
                {
                    result.push(handler);
                }
            }
            return result;
        }
    }
}
