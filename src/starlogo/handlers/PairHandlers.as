package starlogo.handlers
{
    /**
     * The handlers of a pair of breeds, in both directions, in the order of their calls: those for which the first agent is the collider, then
     * those for which the second is.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** The handlers that are called in a frame in which the two touch. */
        public var handlers:Vector.<CollisionHandler>;

        /** How many of them, at the beginning, have the first agent for their collider; the rest have the second. */
        public var forwardCount:int;

        /** Whether any handler takes a contact, in the first frame of a touch or later. */
        public var takesContacts:Boolean = false;

        /** The handlers of the first frame of a touch. Null if no handler is for starts or ends of touches. */
        public var ofStart:PairHandlers = null;

        /** The handlers of the first frame after a touch. Null if no handler is for starts or ends of touches. */
        public var ofEnd:PairHandlers = null;

        /**
         * @param forward those for which the first agent is the collider
         * @param back those for which the second is
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
