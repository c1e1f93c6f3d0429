package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * Where the handlers' third argument comes from: how the agents of a frame's pairs touch.
     *
     * @private
     */
    public interface ContactSource
    {
        /** Begins a frame: there are so many pairs, numbered from 0, and none of their contacts is known. */
        function beginFrame(pairCount:int):void;

        /** Finds the contact of a pair, before the first handler runs: it may move the agents of other pairs. */
        function find(pair:int, first:Agent, second:Agent):void;

        /**
         * The contact of a pair, in an object that the next call overwrites; computed now, if it has not been.
         *
         * @param pair its number
         * @param first the first agent of the pair
         * @param second the collidee
         * @param isBack whether it is to be that of the second as the collider
         */
        function contactOf(pair:int, first:Agent, second:Agent, isBack:Boolean):Object;

        /** The same for a handler that may not look at it: computed when it does. */
        function contactWhenAsked(pair:int, first:Agent, second:Agent, isBack:Boolean):Object;
    }
}
