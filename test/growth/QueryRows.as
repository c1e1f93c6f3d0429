package growth
{
    /** Queries and walking. */
    public final class QueryRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [];
        }
    }
}
