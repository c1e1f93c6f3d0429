package starlogo.broadphase
{
    import flash.errors.IllegalOperationError;

    /**
     * Receives the pairs that Bins find. A class rather than an interface because calls through an interface cost
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
         * Takes the pairs of a member with others whose circles on the ground overlap its own. All at once: a call for each pair
         * would cost as much as its test.
         *
         * @param slot the member's slot in the bins, see Bins.memberAt
         * @param others the first of them are the slots of the candidates; no pair comes twice, in either order
         * @param count how many
         */
        public function onCandidates(slot:int, others:Vector.<int>, count:int):void
        {
            throw new IllegalOperationError(this + " does not implement onCandidates");
        }
    }
}
