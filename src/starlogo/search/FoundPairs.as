package starlogo.search
{
    import starlogo.agents.Agent;

    /**
     * The pairs that a search has found: two agents a pair, in the order of the list, and the place of each in the list.
     *
     * @private
     */
    public final class FoundPairs
    {
        /** How many agents there are: two a pair. What comes after them in the vectors is left from other searches. */
        public var length:int = 0;

        /** The agents: a0, b0, a1, b1, ... */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /** The place of each in the list that was searched. */
        public var places:Vector.<int> = new Vector.<int>();

        /** No pairs. */
        public function FoundPairs()
        {
        }

        /** Sets how many agents there are, and lets go of those that earlier searches have left after them. */
        public function end(length:int):void
        {
            // a vector that shrinks and grows again is a new one in a JavaScript engine
            for (var i:int = length; i < this.length; i++)
            {
                agents[i] = null;
            }
            this.length = length;
        }
    }
}
