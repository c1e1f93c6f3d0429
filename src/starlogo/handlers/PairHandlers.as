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
        public var breed:int;

        /** The number of the second agent's breed. */
        public var otherBreed:int;

        /** The handlers that were added for just these two breeds, the first one as the collider. The members below are made of these and others. */
        public var added:AddedHandlers = new AddedHandlers();

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
    }
}
