package starlogo.collision
{
    import flash.errors.EOFError;
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.geometry.isInWorld;
    import starlogo.handlers.Touch;
    import starlogo.handlers.TouchTracker;
    import starlogo.search.AgentTable;
    import starlogo.search.KeptPlaces;
    import starlogo.search.CollisionSearch;
    import starlogo.terrain.FixtureAgent;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Writes and reads the snapshots of one Collision. A snapshot has what the next frame needs besides the agents' traits. Agents are numbers
     * in it: their indices in the last frame's list.
     *
     * <p>The bytes are: a mark; the number of agents, and for each whether it may have a motion from its last position, and that position; the
     * number of breeds' names, and the names; the number of touching pairs, and for each its agents, their breeds, and whether it touches both
     * ways; the ground, if there is one. After the indices of the agents come those of the ground, of the edges, and of a ground and edges that
     * were exchanged after the frame: their touches end in the next frame.</p>
     *
     * <p>The ground's bytes are: the number of columns; the number of rows; the width of a cell; its place; whether the surface is columns; then
     * the heights. After a height of 0 comes the number of heights that are 0 from there on, and only the first of them is written.</p>
     *
     * <p>Nothing in the bytes depends on the program that runs. Machines in step write the same bytes.</p>
     */
    internal final class Snapshots
    {
        // "SLF2"
        private static const MARK:uint = 0x534C4632;
        private static const AGENTS_AT:int = 8;
        private static const BYTES_PER_AGENT:int = 25;

        private var _who:SnapshotAgents = new SnapshotAgents();

        // The ground's and the edges' agents that were exchanged before the last snapshot; others stand for them in another Collision.
        private var _former:Vector.<Agent> = new <Agent>[new FixtureAgent(Breeds.TERRAIN), new FixtureAgent(Breeds.EDGE)];

        /**
         * Returns the bytes of a snapshot.
         *
         * @param tracker knows the touching pairs
         * @param table has the last frame's agents
         * @param agents the last frame's list. It is empty if there was no frame
         * @param keepsMotions whether the agents' next motions begin at their positions in the table
         * @param terrain the ground, or null
         * @param fixtures the agents of the ground and of the edges, or null
         * @throws IllegalOperationError if the collision system has searched another list
         */
        public function write(tracker:TouchTracker, table:AgentTable, agents:Vector.<Agent>, keepsMotions:Boolean, terrain:Terrain,
                fixtures:Vector.<Agent>):ByteArray
        {
            if (agents.length > 0 && !table.isListed(agents))
            {
                throw new IllegalOperationError("the collision system has searched another list since the last frame");
            }
            var bytes:ByteArray = newBytes();
            bytes.writeUnsignedInt(MARK);
            bytes.writeInt(agents.length);
            KeptPlaces.write(table, agents, bytes, keepsMotions);
            writePairs(bytes, tracker, table, fixtures);
            if (terrain != null)
            {
                writeGround(bytes, terrain);
            }
            _who.note(bytes, agents);
            bytes.position = 0;
            return bytes;
        }

        /**
         * Goes back to a snapshot. The last search is then the one before the snapshot was taken.
         *
         * @param terrain the ground, which gets the heights that it had then; or null
         * @param fixtures the agents of the ground and of the edges, or null
         * @return the tracker that knows which pairs touched then
         * @throws ArgumentError as Collision.restore does; nothing has changed then
         */
        public function read(bytes:ByteArray, agents:Vector.<Agent>, search:CollisionSearch, terrain:Terrain, fixtures:Vector.<Agent>):TouchTracker
        {
            search.table.propose(agents);
            var copy:ByteArray = newBytes();
            copy.writeBytes(bytes);
            copy.position = 0;
            if (copy.length < AGENTS_AT || copy.readUnsignedInt() != MARK)
            {
                throw new ArgumentError("bytes are no snapshot: they do not begin as one");
            }
            var touches:TouchTracker = new TouchTracker();
            try
            {
                var groundAt:uint = checkAll(copy, agents, terrain, fixtures, touches);
            }
            catch (error:EOFError)
            {
                check(false);
            }
            copy.position = AGENTS_AT;
            search.restorePositions(agents, copy);
            if (terrain != null)
            {
                copy.position = groundAt;
                terrain.isBlocky = copy.readBoolean();
                terrain.setHeights(0, 0, terrain.columns, terrain.rows, readHeights(copy, terrain));
            }
            return touches;
        }

        private function writePairs(bytes:ByteArray, tracker:TouchTracker, table:AgentTable, fixtures:Vector.<Agent>):void
        {
            var breeds:Vector.<int> = new Vector.<int>();
            var pairs:ByteArray = newBytes();
            for (var i:int = 0; i < tracker.count; i++)
            {
                var pair:Touch = tracker.pairAt(i);
                pairs.writeInt(table.ranks[table.rowOf(pair.first)]);
                pairs.writeInt(Breeds.isReserved(pair.secondBreed) ? table.count + indexOfFixture(pair, fixtures) : table.ranks[table.rowOf(pair.second)]);
                pairs.writeInt(indexIn(breeds, pair.firstBreed));
                pairs.writeInt(indexIn(breeds, pair.secondBreed));
                pairs.writeBoolean(pair.isBothWays);
            }
            bytes.writeInt(breeds.length);
            for (i = 0; i < breeds.length; i++)
            {
                var name:ByteArray = newBytes();
                name.writeUTFBytes(Breeds.nameOf(breeds[i]));
                bytes.writeInt(name.length);
                bytes.writeBytes(name);
            }
            bytes.writeInt(tracker.count);
            bytes.writeBytes(pairs);
        }

        // The reserved breeds have the first numbers, and the ground's breed is the first of them.
        private function indexOfFixture(pair:Touch, fixtures:Vector.<Agent>):int
        {
            var index:int = pair.secondBreed;
            if (pair.second !== fixtures[index])
            {
                _former[index] = pair.second;
                index += fixtures.length;
            }
            return index;
        }

        private static function writeGround(bytes:ByteArray, terrain:Terrain):void
        {
            bytes.writeInt(terrain.columns);
            bytes.writeInt(terrain.rows);
            bytes.writeDouble(terrain.cellWidth);
            bytes.writeDouble(terrain.x);
            bytes.writeDouble(terrain.y);
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

        // Checks all bytes, and reads the touching pairs. Returns where the ground's surface begins.
        private function checkAll(bytes:ByteArray, agents:Vector.<Agent>, terrain:Terrain, fixtures:Vector.<Agent>, touches:TouchTracker):uint
        {
            var count:uint = bytes.readUnsignedInt();
            check(count <= (bytes.length - AGENTS_AT) / BYTES_PER_AGENT);
            _who.check(bytes, count, agents);
            bytes.position = AGENTS_AT;
            for (var i:int = 0; i < count; i++)
            {
                check(bytes.readUnsignedByte() <= 1 && isInWorld(bytes.readDouble(), bytes.readDouble(), bytes.readDouble()));
            }
            readPairs(bytes, agents.concat(fixtures, _former), count, touches);
            var hasGround:Boolean = bytes.position < bytes.length;
            if (hasGround != (terrain != null))
            {
                var which:String = hasGround ? "without" : "with";
                throw new ArgumentError("bytes are no snapshot of a Collision " + which + " ground");
            }
            var groundAt:uint = bytes.position;
            if (hasGround)
            {
                checkGround(bytes, terrain);
                groundAt = bytes.position;
                bytes.readBoolean();
                readHeights(bytes, terrain);
            }
            check(bytes.position == bytes.length);
            return groundAt;
        }

        private static function readPairs(bytes:ByteArray, agents:Vector.<Agent>, count:int, touches:TouchTracker):void
        {
            var breeds:Vector.<int> = new Vector.<int>();
            for (var left:uint = bytes.readUnsignedInt(); left > 0; left--)
            {
                var name:String = bytes.readUTFBytes(bytes.readUnsignedInt());
                check(name != "");
                breeds.push(Breeds.numberOf(name));
            }
            var pairs:uint = bytes.readUnsignedInt();
            for (left = pairs; left > 0; left--)
            {
                var first:uint = bytes.readUnsignedInt();
                var second:uint = bytes.readUnsignedInt();
                var firstBreed:uint = bytes.readUnsignedInt();
                var secondBreed:uint = bytes.readUnsignedInt();
                var flag:int = bytes.readUnsignedByte();
                check(first < count && second < agents.length && first != second && firstBreed < breeds.length && secondBreed < breeds.length && flag <= 1);
                if (agents[second] == null)
                {
                    var missing:String = second == count ? "ground" : "bounds";
                    throw new ArgumentError("bytes are no snapshot of a Collision without " + missing);
                }
                touches.start(agents[first], agents[second], breeds[firstBreed], breeds[secondBreed], flag == 1);
            }
            // each agent is there once
            check(touches.count == pairs);
        }

        private static function checkGround(bytes:ByteArray, terrain:Terrain):void
        {
            var columns:int = bytes.readInt();
            var rows:int = bytes.readInt();
            var cellWidth:Number = bytes.readDouble();
            var x:Number = bytes.readDouble();
            var y:Number = bytes.readDouble();
            if (columns != terrain.columns || rows != terrain.rows || cellWidth != terrain.cellWidth || x != terrain.x || y != terrain.y)
            {
                throw new ArgumentError("bytes are no snapshot with this ground, but with " + columns + " by " + rows + " heights from (" + x + ", " + y
                        + ") on, in cells " + cellWidth + " wide");
            }
        }

        private static function readHeights(bytes:ByteArray, terrain:Terrain):Vector.<Number>
        {
            var heights:Vector.<Number> = new Vector.<Number>(terrain.columns * terrain.rows);
            for (var at:uint = 0; at < heights.length; at += count)
            {
                heights[at] = bytes.readDouble();
                var count:uint = heights[at] == 0 ? bytes.readUnsignedInt() : 1;
                check(isInWorld(heights[at], 0, 0) && count <= heights.length - at);
            }
            return heights;
        }

        private static function check(isSnapshot:Boolean):void
        {
            if (!isSnapshot)
            {
                throw new ArgumentError("bytes are no snapshot any more: they begin as one, but something in them was changed or cut off");
            }
        }

        private static function indexIn(breeds:Vector.<int>, breed:int):int
        {
            var index:int = breeds.indexOf(breed);
            return index < 0 ? breeds.push(breed) - 1 : index;
        }

        private static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }
    }
}
