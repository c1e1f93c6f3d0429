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
        /** Those of a frame in which the two collide. */
        public var handlers:Vector.<CollisionHandler>;

        /** How many of them, at the beginning, have the first agent for their collider; the rest have the second. */
        public var forwardCount:int;

        /** Whether any takes a contact, those of the first frame included. */
        public var takesContacts:Boolean = false;

        /** Those of the first frame of a contact; null if there are none for starts or ends of contacts. */
        public var ofStart:PairHandlers = null;

        /** Those of the first frame without the contact; null in the same case. */
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
