package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Computes the third argument of handlers: the contacts of a frame's pairs.
     *
     * @private
     */
    public interface ContactSource
    {
        /** Begins a frame with this number of pairs. None of their contacts is known yet. */
        function beginFrame(pairCount:int):void;

        /** Computes the contact of a pair, unless it is known. This happens before the first handler runs, because a handler may move agents. */
        function find(pair:int, first:Agent, second:Agent):void;

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If the breeds have changed since the frame began, it
         * computes the contact now.
         *
         * @param handler the receiver. If it may ignore the contact, the contact is computed when the handler reads it
         * @param pair the number of the pair, from 0
         * @param first the first agent of the pair
         * @param second the second agent
         * @param isBack whether the second agent is the collider
         */
        function contactFor(handler:CollisionHandler, pair:int, first:Agent, second:Agent, isBack:Boolean):Object;
    }
}
