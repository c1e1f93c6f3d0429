package starlogo.collision
{
    /** The handlers of a pair of breeds, both ways: whom the first one's collider calls, then whom the second one's does. */
    internal final class PairHandlers
    {
        /** In the order of their calls. */
        public var handlers:Vector.<CollisionHandler>;

        /** So many at the beginning have the first agent for their collider, the rest the second. */
        public var forwardCount:int;

        /**
         * @param forward those for which the first agent is the collider, or null
         * @param back those for which the second is, or null
         */
        public function PairHandlers(forward:Vector.<CollisionHandler>, back:Vector.<CollisionHandler>)
        {
            handlers = forward == null ? new Vector.<CollisionHandler>() : forward.concat();
            forwardCount = handlers.length;
            if (back != null)
            {
                handlers = handlers.concat(back);
            }
        }
    }
}
