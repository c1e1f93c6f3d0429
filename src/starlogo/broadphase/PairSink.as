package starlogo.broadphase
{
    import flash.errors.IllegalOperationError;

    /**
     * Receives pairs of rows that are near each other. It is a class and not an interface, because a call through an interface takes 1.5 times as long.
     *
     * @private
     */
    public class PairSink
    {
        /**
         * Takes the pairs of one row: the others are all whose extents overlap its own, and some whose circles on the ground do. All come in one
         * call, because a call for each pair would cost as much as its test.
         *
         * @param others begins with the candidates, which may be overwritten; no pair comes twice, in either order
         * @param count the number of candidates
         * @param level the level of the candidates, or of the row if that is coarser. Extents that touch may be its slack apart
         */
        public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
        {
            throw new IllegalOperationError(this + " does not implement onCandidates");
        }
    }
}
