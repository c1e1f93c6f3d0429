package starlogo.handlers
{
    /**
     * The handlers of a pair of breeds, both ways, in the order of their calls: those for which the first agent is the collider, then
     * those for which the second is.
     *
     * @private
     */
    public final class PairHandlers
    {
        /** Those of a frame in which the two touch. */
        public var handlers:Vector.<CollisionHandler>;

        /** So many at the beginning have the first agent for their collider, the rest the second. */
        public var forwardCount:int;

        /** Whether any asks for contacts, those of the first frame included. */
        public var takesContacts:Boolean = false;

        /** All those of the first frame of a touch; null if no handler asks when touches begin or end. */
        public var ofStart:PairHandlers = null;

        /** Those of the first frame without it; null in the same case. */
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
