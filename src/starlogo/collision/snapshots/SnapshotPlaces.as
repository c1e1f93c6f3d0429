package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Points;
    import starlogo.engine;
    import starlogo.geometry.isInWorld;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The part of a snapshot that belongs to a table: the place of each agent in the last search, and whether the agent's motion begins there.
     *
     * @private
     */
    internal final class SnapshotPlaces
    {
        /** The number of bytes for each agent. */
        public static const SIZE:int = 1 + 3 * 8;

        /**
         * Writes the places.
         *
         * @param list the list of the last search, or an empty list
         * @param keepsMotions false to write that no agent has a motion
         */
        public static function write(bytes:ByteArray, list:Vector.<Agent>, table:AgentTable, keepsMotions:Boolean):void
        {
            var places:Points = table.places;
            for (var i:int = 0; i < list.length; i++)
            {
                var row:int = table.listed.rows.values[i];
                bytes.writeBoolean(keepsMotions && table.shapes[row] != null && table.isMotionStart(row)
                        && table.shapes[row].modelName == list[i].shape);
                bytes.writeDouble(places.x[row]);
                bytes.writeDouble(places.y[row]);
                bytes.writeDouble(places.z[row]);
            }
        }

        /**
         * Reads the places of this number of agents: four numbers for each, x, y, z, and 1 for a motion or 0.
         *
         * @throws RangeError if the bytes are none
         * @throws EOFError if they are cut off
         */
        public static function read(bytes:ByteArray, count:int):Vector.<Number>
        {
            var places:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                var flag:int = bytes.readUnsignedByte();
                var x:Number = bytes.readDouble();
                var y:Number = bytes.readDouble();
                var z:Number = bytes.readDouble();
                if (flag > 1 || !isInWorld(x, y, z))
                {
                    throw new RangeError("a place is not in the world");
                }
                places.push(x, y, z, flag);
            }
            return places;
        }

        /**
         * Puts a list of agents into a table as if the last search had seen them at these places.
         *
         * @param places what <code>read()</code> has returned for as many agents
         * @throws ArgumentError as <code>AgentTable.read()</code> does
         */
        public static function restore(places:Vector.<Number>, list:Vector.<Agent>, table:AgentTable):void
        {
            table.read(list);
            for (var i:int = 0; i < list.length; i++)
            {
                table.writeLastPlace(table.listed.rows.values[i], places[4 * i], places[4 * i + 1], places[4 * i + 2], places[4 * i + 3] == 1);
            }
        }
    }
}
