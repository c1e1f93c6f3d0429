package starlogo.search.table
{
    import starlogo.search.ModelShape;
    import starlogo.search.NumberList;

    /** Rows of a table whose agents have got another body since they were read last, with the shapes that they get. A record. */
    internal final class ReshapedRows
    {
        /** The rows. */
        public var rows:NumberList = new NumberList();

        /** The new shapes of the rows in their order; null while a model is loading, and for a row that keeps its shape. */
        public var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
    }
}
