package starlogo.handlers
{
    /**
     * The handlers of a pair of breeds, in the order of their calls. First come the handlers whose collider is the first agent, then the handlers
     * whose collider is the second agent.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** The handlers that are called in a frame in which the two touch. */
        public var handlers:Vector.<CollisionHandler>;

        /** The number of handlers whose collider is the first agent. */
        public var forwardCount:int;

        /** Whether any handler takes a contact, in the first frame of a touch or later. */
        public var takesContacts:Boolean = false;

        /** The handlers of the first frame of a touch. Null if no handler is for starts or ends of touches. */
        public var ofStart:PairHandlers = null;

        /** The handlers of the first frame after a touch. Null if no handler is for starts or ends of touches. */
        public var ofEnd:PairHandlers = null;

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
                takesContacts = takesContacts || handler.takesContact;
            }
        }
    }
}
