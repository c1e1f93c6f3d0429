package starlogo.search.table
{
    import starlogo.data.IntList;

    /**
     * What has changed in a list of agents since the last search, as a record. AgentTable writes it.
     *
     * @private
     */
    public final class ListChanges
    {
        /** The rows whose agents have changed, or whose models were replaced. */
        public var rows:IntList = new IntList();

        /** The list indices of those whose bodies have changed. */
        public var reshaped:IntList = new IntList();

        /** Whether an agent of the list sweeps. */
        public var anySweeps:Boolean = false;
    }
}
