package starlogo.collision
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Writes and reads the heights of the ground in a snapshot. Heights of 0 that follow one another take twelve bytes together.
     *
     * <p>The bytes are: the number of columns; the number of rows; whether the surface is columns; then the heights. After a height of 0
     * comes the number of heights that are 0 from there on, and only the first of them is written.</p>
     */
    internal final class SnapshotHeights
    {
        // The heights and the surface of the snapshot that was read last.
        private var _heights:Vector.<Number>;
        private var _isBlocky:Boolean;

        /** Begins without a snapshot. */
        public function SnapshotHeights()
        {
        }

        /** Writes a terrain. */
        public function write(bytes:ByteArray, terrain:Terrain):void
        {
            bytes.writeInt(terrain.columns);
            bytes.writeInt(terrain.rows);
            bytes.writeBoolean(terrain.isBlocky);
            var heights:Vector.<Number> = terrain.grid.heights;
            for (var at:int = 0; at < heights.length; at += count)
            {
                var count:int = 1;
                bytes.writeDouble(heights[at]);
                if (heights[at] == 0)
                {
                    while (at + count < heights.length && heights[at + count] == 0)
                    {
                        count++;
                    }
                    bytes.writeInt(count);
                }
            }
        }

        /**
         * Reads the heights that <code>write()</code> has written. The terrain does not change yet. If the bytes are no snapshot, it
         * returns false or throws an EOFError.
         *
         * @param bytes their heights end at the position <code>end</code>
         * @param terrain the ground; null if there is none, and the bytes should have none
         * @throws ArgumentError if the snapshot has ground and the Collision has none, or the reverse, or if the snapshot has another number
         *     of columns or rows than the terrain
         */
        public function read(bytes:ByteArray, end:int, terrain:Terrain):Boolean
        {
            var hasGround:Boolean = bytes.position < end;
            if (hasGround != (terrain != null))
            {
                var which:String = hasGround ? "without" : "with";
                throw new ArgumentError("bytes are no snapshot of a Collision " + which + " ground");
            }
            return !hasGround || readHeights(bytes, terrain);
        }

        /** Gives a terrain the heights that were read. */
        public function restore(terrain:Terrain):void
        {
            terrain.isBlocky = _isBlocky;
            terrain.setHeights(0, 0, terrain.columns, terrain.rows, _heights);
            _heights = null;
        }

        private function readHeights(bytes:ByteArray, terrain:Terrain):Boolean
        {
            var columns:int = bytes.readInt();
            var rows:int = bytes.readInt();
            if (columns != terrain.columns || rows != terrain.rows)
            {
                throw new ArgumentError("bytes are no snapshot with this ground, but with " + columns + " by " + rows + " heights");
            }
            _isBlocky = bytes.readBoolean();
            _heights = new Vector.<Number>(columns * rows);
            for (var at:uint = 0; at < _heights.length; at += count)
            {
                _heights[at] = bytes.readDouble();
                var count:uint = _heights[at] == 0 ? bytes.readUnsignedInt() : 1;
                if (!(Math.abs(_heights[at]) <= Agent.LARGEST_COORDINATE) || count > _heights.length - at)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
