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
        public var handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        /** The number of handlers whose collider is the first agent. */
        public var forwardCount:int = 0;

        /** Whether any handler takes a contact, in the first frame of a touch or later. */
        public var takesContacts:Boolean = false;

        /** The handlers of the first frame of a touch. Null if no handler is for starts or ends of touches. */
        public var ofStart:PairHandlers = null;

        /** The handlers of the first frame after a touch. Null if no handler is for starts or ends of touches. */
        public var ofEnd:PairHandlers = null;

        /**
         * @param forward the handlers whose collider is the first agent
         * @param back the handlers whose collider is the second agent
         * @param first handlers of kinds from this one on count
         * @param last the last kind that counts
         */
        public function PairHandlers(forward:Vector.<CollisionHandler>, back:Vector.<CollisionHandler>, first:int, last:int)
        {
            var count:int = 0;
            for each (var handler:CollisionHandler in forward.concat(back))
            {
                if (handler.kind >= first && handler.kind <= last)
                {
                    handlers.push(handler);
                    takesContacts ||= handler.takesContact;
                    forwardCount += count < forward.length ? 1 : 0;
                }
                count++;
            }
        }
    }
}
