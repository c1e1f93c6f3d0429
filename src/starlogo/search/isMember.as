package starlogo.search
{
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Whether a row of a table is a member of a search: it has a shape, its breed is of interest, and its agent takes part.
     *
     * @private
     */
    internal function isMember(row:int, table:AgentTable, input:FrameInput):Boolean
    {
        return table.shapes[row] != null && (input.interests == null || input.interests.representativeOf(table.breeds[row]) >= 0)
            && (input.admitted == null || input.admitted[table.list.ranks[row]]);
    }
}
