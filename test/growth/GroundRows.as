package growth
{
    /** The ground. */
    public final class GroundRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [];
        }
    }
}
