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

        /**
         * Computes the contact of a pair, unless it is known. This happens before the first handler runs, because handlers may change
         * everything. Only if a handler has changed a breed, so that other handlers take the contact, it happens later.
         */
        function find(pair:int, first:Agent, second:Agent):void;

        /**
         * Returns the contact of a pair, in an object that the next call overwrites.
         *
         * @param pair the number of the pair, from 0
         * @param first the first agent of the pair
         * @param second the second agent
         * @param isBack whether the second agent is the collider
         */
        function contactFor(pair:int, first:Agent, second:Agent, isBack:Boolean):Object;
    }
}
