package starlogo.queries
{
    import flash.errors.IllegalOperationError;

    /**
     * Says which rows count in a search. A class rather than an interface because calls through an interface cost half as much again.
     *
     * @private
     */
    public class RowTest
    {
        /** For subclasses only. */
        public function RowTest()
        {
        }

        /** Whether a row counts. */
        public function accepts(row:int):Boolean
        {
            throw new IllegalOperationError(this + " does not implement accepts");
        }
    }
}
