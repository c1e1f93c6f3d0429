package starlogo.broadphase
{
    import flash.errors.IllegalOperationError;

    /**
     * What Bins hand the pairs to that they find. A class rather than an interface because calls through an interface cost
     * half as much again.
     *
     * @private
     */
    public class PairSink
    {
        /** For subclasses only. */
        public function PairSink()
        {
        }

        /**
         * Takes the pairs of a proxy with others whose ground rectangles overlap its own. All at once: a call for each pair
         * would cost as much as its test.
         *
         * @param proxy a proxy that was added
         * @param others so many at the beginning are those that it may meet; no pair comes twice, in either order
         * @param count how many
         */
        public function onCandidates(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):void
        {
            throw new IllegalOperationError(this + " does not implement onCandidates");
        }
    }
}
