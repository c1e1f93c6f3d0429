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
         * Takes two proxies whose ground rectangles overlap.
         *
         * @param a a proxy that was added
         * @param b another one; no pair comes twice, in either order
         */
        public function onCandidatePair(a:AgentProxy, b:AgentProxy):void
        {
            throw new IllegalOperationError(this + " does not implement onCandidatePair");
        }
    }
}
