package starlogo.handlers
{
    /**
     * The handlers of a pair of breeds, in the order of their calls. First come the handlers whose collider is the first agent, then the handlers
     * whose collider is the second agent. In each half, handlers for starts come first, and handlers for ends come last.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** The number of the first agent's breed. */
        public var breed:int = -1;

        /** The number of the second agent's breed. */
        public var otherBreed:int = -1;

        /** The handlers of all kinds. */
        public var handlers:Vector.<CollisionHandler>;

        /** The number of handlers whose collider is the first agent. */
        public var forwardCount:int;

        /** Whether any handler takes the contact of a touch. */
        public var takesContacts:Boolean = false;

        /** Whether any handler is for starts or ends of touches. */
        public var tracksTouches:Boolean = false;

        /**
         * @param forward the handlers whose collider is the first agent
         * @param back the handlers whose collider is the second agent
         */
        public function PairHandlers(forward:Vector.<CollisionHandler>, back:Vector.<CollisionHandler>)
        {
            handlers = forward.concat(back);
            forwardCount = forward.length;
            for each (var handler:CollisionHandler in handlers)
            {
                takesContacts ||= handler.takesContact && handler.kind != CollisionHandler.END;
                tracksTouches ||= handler.kind != CollisionHandler.COLLISION;
            }
        }
    }
}
