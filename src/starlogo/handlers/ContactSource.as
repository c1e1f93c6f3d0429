package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Computes the handlers' third argument: how the agents of a frame's pairs touch.
     *
     * @private
     */
    public interface ContactSource
    {
        /** Begins a frame: there are so many pairs, numbered from 0, and none of their contacts is known. */
        function beginFrame(pairCount:int):void;

        /** Computes the contact of a pair, unless it is known. A handler may move agents, so contacts are computed before the first handler runs. */
        function find(pair:int, first:Agent, second:Agent):void;

        /**
         * The contact of a pair, in an object that the next call overwrites. If its breeds have changed since the frame began, it is computed now.
         *
         * @param handler will get it. If it need not look at it, it is computed when it does
         * @param pair its number
         * @param first the first agent of the pair
         * @param second the other
         * @param isBack whether the second agent is the collider
         */
        function contactFor(handler:CollisionHandler, pair:int, first:Agent, second:Agent, isBack:Boolean):Object;
    }
}
