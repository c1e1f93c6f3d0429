package starlogo.broadphase
{
    import flash.errors.IllegalOperationError;

    /**
     * Receives the pairs that Bins find. It is a class and not an interface, because a call through an interface takes 1.5 times as long.
     *
     * @private
     */
    public class PairSink
    {
        /**
         * Takes the pairs of one member with all others whose circles on the ground overlap its own. All come in one call, because a call
         * for each pair would cost as much as its test.
         *
         * @param slot the member's slot in the bins, see Bins.rowAt
         * @param others begins with the slots of the candidates; no pair comes twice, in either order
         * @param count the number of candidates
         */
        public function onCandidates(slot:int, others:Vector.<int>, count:int):void
        {
            throw new IllegalOperationError(this + " does not implement onCandidates");
        }
    }
}
