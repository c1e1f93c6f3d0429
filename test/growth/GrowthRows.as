package growth
{
    /** All rows of `./antw growth`. Each list is a file of its own. */
    public final class GrowthRows
    {
        /** The rows whose names contain a part. */
        public static function named(part:String):Array
        {
            return all.filter(function(row:GrowthRow, index:int, rows:Array):Boolean
                {
                    return row.name.indexOf(part) >= 0;
                });
        }

        /** All rows. */
        public static function get all():Array
        {
            return FileRows.all.concat(ShapeRows.all, AgentRows.all, GroundRows.all, QueryRows.all);
        }
    }
}
