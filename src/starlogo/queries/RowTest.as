package starlogo.queries
{
    import flash.errors.IllegalOperationError;

    /**
     * Says which rows of a list count in a search. A class rather than an interface because calls through an interface cost half as much again.
     *
     * @private
     */
    public class RowTest
    {
        /** For subclasses only. */
        public function RowTest()
        {
        }

        /** Whether a row counts. @param member its number in the list */
        public function accepts(member:int):Boolean
        {
            throw new IllegalOperationError(this + " does not implement accepts");
        }
    }
}
