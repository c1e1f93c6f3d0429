package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.RowPlaces;

    use namespace engine;

    /**
     * Writes and reads the part of a snapshot that belongs to a table: the place of each agent in the last search, and whether the agent's
     * motion begins there.
     */
    internal final class SnapshotPlaces
    {
        /**
         * Writes the places.
         *
         * @param list the list of the last search, or an empty list
         * @param keepsMotions false to write that no agent has a motion
         */
        public static function write(bytes:ByteArray, list:Vector.<Agent>, table:AgentTable, keepsMotions:Boolean):void
        {
            var places:RowPlaces = table.places.last;
            for (var i:int = 0; i < list.length; i++)
            {
                var row:int = table.list.rows.numbers[i];
                bytes.writeBoolean(keepsMotions && table.shapes[row] != null && places.isMotionStart(row, list[i])
                        && table.shapes[row].modelName == list[i].shape);
                bytes.writeDouble(places.x[row]);
                bytes.writeDouble(places.y[row]);
                bytes.writeDouble(places.z[row]);
            }
        }

        /**
         * Reads a list of agents into a table as if the last search had seen them at the places that were written.
         *
         * @param bytes written for the same number of agents
         * @throws ArgumentError as <code>AgentTable.read()</code> does
         */
        public static function restore(bytes:ByteArray, list:Vector.<Agent>, table:AgentTable):void
        {
            table.read(list);
            for (var i:int = 0; i < list.length; i++)
            {
                var hasMotion:Boolean = bytes.readBoolean();
                var x:Number = bytes.readDouble();
                var y:Number = bytes.readDouble();
                var z:Number = bytes.readDouble();
                table.setLastPlace(table.list.rows.numbers[i], x, y, z, hasMotion);
            }
        }
    }
}
