package starlogo.collision
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Writes and reads the heights of the ground in a snapshot. A run of heights that are 0 takes eight bytes together, so flat ground
     * takes only a few bytes.
     *
     * <p>The bytes are: the number of columns; the number of rows; whether the surface is columns; then runs, until all heights are there.
     * A run is the number of heights that are 0, the number of other heights that follow, and these other heights.</p>
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
            for (var at:int = 0; at < heights.length; )
            {
                var first:int = endOfRun(heights, at, true);
                var end:int = endOfRun(heights, first, false);
                bytes.writeInt(first - at);
                bytes.writeInt(end - first);
                for (at = first; at < end; at++)
                {
                    bytes.writeDouble(heights[at]);
                }
            }
        }

        /**
         * Reads the heights that <code>write()</code> has written. The terrain does not change yet. If the bytes are no snapshot, it
         * returns false or throws an EOFError.
         *
         * @throws ArgumentError if the snapshot has another number of columns or rows than the terrain
         */
        public function read(bytes:ByteArray, terrain:Terrain):Boolean
        {
            var columns:int = bytes.readInt();
            var rows:int = bytes.readInt();
            if (columns != terrain.columns || rows != terrain.rows)
            {
                throw new ArgumentError("bytes are no snapshot with this ground, but with " + columns + " by " + rows + " heights");
            }
            _isBlocky = bytes.readBoolean();
            _heights = new Vector.<Number>();
            while (_heights.length < columns * rows)
            {
                var zeros:uint = bytes.readUnsignedInt();
                var others:uint = bytes.readUnsignedInt();
                if (zeros + others == 0 || zeros + others > columns * rows - _heights.length)
                {
                    return false;
                }
                for (; zeros > 0; zeros--)
                {
                    _heights.push(0);
                }
                for (; others > 0; others--)
                {
                    var height:Number = bytes.readDouble();
                    if (!(Math.abs(height) <= Agent.LARGEST_COORDINATE))
                    {
                        return false;
                    }
                    _heights.push(height);
                }
            }
            return true;
        }

        /** Gives a terrain the heights that were read. */
        public function restore(terrain:Terrain):void
        {
            terrain.isBlocky = _isBlocky;
            terrain.setHeights(0, 0, terrain.columns, terrain.rows, _heights);
            _heights = null;
        }

        private static function endOfRun(heights:Vector.<Number>, at:int, isOfZeros:Boolean):int
        {
            while (at < heights.length && (heights[at] == 0) == isOfZeros)
            {
                at++;
            }
            return at;
        }
    }
}
