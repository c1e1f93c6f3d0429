package starlogo.collision
{
    import flash.errors.EOFError;
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.handlers.Touch;
    import starlogo.handlers.TouchTracker;
    import starlogo.search.AgentTable;
    import starlogo.search.CollisionSearch;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /**
     * Writes and reads the snapshots of one Collision. A snapshot has what the next frame needs besides the agents' traits. Agents are numbers
     * in it: their indices in the last frame's list.
     *
     * <p>The bytes are: a mark; the number of agents, and for each whether it may have a motion from its last position, and that position; the
     * number of breeds' names, and the names; the number of touching pairs, and for each its agents, their breeds, and whether it touches both
     * ways; the heights, if there is ground (SnapshotHeights); the agents' ids (SnapshotAgents).</p>
     */
    internal final class Snapshots
    {
        // "SLF1"
        private static const MARK:uint = 0x534C4631;
        private static const AGENTS_AT:int = 8;
        private static const BYTES_PER_AGENT:int = 25;

        // Receives the touching pairs when a snapshot is read; otherwise empty.
        private var _read:TouchTracker = new TouchTracker();
        private var _who:SnapshotAgents = new SnapshotAgents();
        private var _heights:SnapshotHeights = new SnapshotHeights();

        /** Creates it for a new Collision. */
        public function Snapshots()
        {
        }

        /**
         * Returns the bytes of a snapshot.
         *
         * @param tracker knows the touching pairs
         * @param search the last frame's search; null if there was none
         * @param agents the last frame's list
         * @param keepsMotions whether the agents' next motions begin at their positions in the search
         * @throws IllegalOperationError if the collision system has searched another list
         */
        public function write(tracker:TouchTracker, search:CollisionSearch, agents:Vector.<Agent>, keepsMotions:Boolean, terrain:Terrain):ByteArray
        {
            if (search != null && !search.table.isListed(agents))
            {
                throw new IllegalOperationError("the collision system has searched another list since the last frame");
            }
            var bytes:ByteArray = newBytes();
            bytes.writeUnsignedInt(MARK);
            bytes.writeInt(agents.length);
            if (search == null)
            {
                // no names, no pairs
                bytes.writeInt(0);
                bytes.writeInt(0);
            }
            else
            {
                writePairs(bytes, tracker, search.table, search.table.writePositions(bytes, keepsMotions));
            }
            if (terrain != null)
            {
                _heights.write(bytes, terrain);
            }
            _who.write(bytes, agents);
            bytes.position = 0;
            return bytes;
        }

        /**
         * Goes back to a snapshot. The last search is then the one before the snapshot was taken.
         *
         * @param tracker knows which pairs touch now; it is empty afterwards, and used in the next call
         * @param terrain the ground, which gets the heights that it had then; or null
         * @param bounds the edges of the world, or null
         * @return the tracker that knows which pairs touched then
         * @throws ArgumentError as Collision.restore does; nothing has changed then
         */
        public function read(bytes:ByteArray, agents:Vector.<Agent>, search:CollisionSearch, tracker:TouchTracker, terrain:Terrain,
                bounds:WorldBounds):TouchTracker
        {
            var copy:ByteArray = newBytes();
            copy.writeBytes(bytes);
            copy.position = 0;
            if (copy.length < AGENTS_AT || copy.readUnsignedInt() != MARK)
            {
                throw new ArgumentError("bytes are no snapshot: they do not begin as one");
            }
            var found:TouchTracker = _read;
            try
            {
                search.table.check(agents);
                check(readAll(copy, agents, found, terrain, bounds));
                copy.position = AGENTS_AT;
                search.restorePositions(agents, copy);
                if (terrain != null)
                {
                    _heights.restore(terrain);
                }
                _read = tracker;
            }
            catch (error:EOFError)
            {
                check(false);
            }
            finally
            {
                _read.clear();
            }
            return found;
        }

        private static function writePairs(bytes:ByteArray, tracker:TouchTracker, table:AgentTable, indices:Vector.<int>):void
        {
            var breeds:Vector.<int> = new Vector.<int>();
            var pairs:ByteArray = newBytes();
            for (var i:int = 0; i < tracker.count; i++)
            {
                var pair:Touch = tracker.pairAt(i);
                pairs.writeInt(indices[table.rowOf(pair.first)]);
                // the reserved breeds have the first numbers, and the ground's breed is the first of them
                pairs.writeInt(Breeds.isReserved(pair.secondBreed) ? table.count + pair.secondBreed : indices[table.rowOf(pair.second)]);
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

        // Checks all bytes, and reads the pairs into a tracker without pairs. If the bytes are no snapshot, it returns false or throws an
        // EOFError.
        private function readAll(bytes:ByteArray, agents:Vector.<Agent>, tracker:TouchTracker, terrain:Terrain, bounds:WorldBounds):Boolean
        {
            var count:int = bytes.readInt();
            if (count < 0 || count > (bytes.length - AGENTS_AT) / BYTES_PER_AGENT)
            {
                return false;
            }
            var end:int = bytes.length - SnapshotAgents.lengthOf(count);
            bytes.position = Math.max(AGENTS_AT, end);
            _who.check(bytes, count, agents);
            bytes.position = AGENTS_AT;
            // the ground and the edges have the indices after the agents
            var all:Vector.<Agent> = agents.concat(new <Agent>[terrain == null ? null : terrain.agent, bounds == null ? null : bounds.agent]);
            return arePositions(bytes, count) && readPairs(bytes, all, count, tracker) && _heights.read(bytes, end, terrain) && bytes.position == end;
        }

        private static function arePositions(bytes:ByteArray, count:int):Boolean
        {
            for (var i:int = 0; i < count; i++)
            {
                if (bytes.readUnsignedByte() > 1 || !isCoordinate(bytes.readDouble()) || !isCoordinate(bytes.readDouble())
                        || !isCoordinate(bytes.readDouble()))
                {
                    return false;
                }
            }
            return true;
        }

        private static function readPairs(bytes:ByteArray, agents:Vector.<Agent>, count:int, tracker:TouchTracker):Boolean
        {
            var breeds:Vector.<int> = new Vector.<int>();
            for (var left:uint = bytes.readUnsignedInt(); left > 0; left--)
            {
                var name:String = bytes.readUTFBytes(bytes.readUnsignedInt());
                if (name == "")
                {
                    return false;
                }
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
                if (first >= count || second >= agents.length || first == second || firstBreed >= breeds.length || secondBreed >= breeds.length || flag > 1)
                {
                    return false;
                }
                if (agents[second] == null)
                {
                    var missing:String = second == count ? "ground" : "bounds";
                    throw new ArgumentError("bytes are no snapshot of a Collision without " + missing);
                }
                tracker.start(agents[first], agents[second], breeds[firstBreed], breeds[secondBreed], flag == 1);
            }
            // each agent is there once
            return tracker.count == pairs;
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

        // False for NaN too.
        private static function isCoordinate(value:Number):Boolean
        {
            return value >= -Agent.LARGEST_COORDINATE && value <= Agent.LARGEST_COORDINATE;
        }
    }
}
