package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.handlers.ContactPair;
    import starlogo.handlers.ContactTracker;
    import starlogo.search.CollisionSearch;

    /**
     * What the next frame depends on besides the agents, as bytes: where the last one saw them, and which pairs touched. Agents are numbers,
     * their places in the last frame's list.
     *
     * <p>The bytes: a mark; how many agents; of each whether it has a motion from where it was seen, and its place; how many names of breeds, and
     * the names; how many pairs, and of each its agents, their breeds, and whether it touches both ways; which agents they are (SnapshotAgents).</p>
     *
     * @private
     */
    public final class FrameRecord
    {
        /** Where the first agent is in the bytes. */
        public static const AGENTS_AT:int = 8;

        // "SLF1"
        private static const MARK:uint = 0x534C4631;
        private static const BYTES_PER_AGENT:int = 25;
        private static const BYTES_PER_PAIR:int = 17;

        private var _tracker:ContactTracker;
        private var _who:SnapshotAgents;
        private var _bytes:ByteArray;
        private var _breeds:Vector.<String> = new Vector.<String>();
        private var _lastBreed:int = -1;

        /**
         * @param tracker knows which pairs touch
         * @param who tells which agents they are
         * @param bytes to be read, at their beginning and little-endian
         */
        public function FrameRecord(tracker:ContactTracker, who:SnapshotAgents, bytes:ByteArray = null)
        {
            _tracker = tracker;
            _who = who;
            _bytes = bytes;
        }

        /**
         * Writes all.
         *
         * @param search of the last frame; null if there was none
         * @param list its agents
         * @param keepsMotions whether agents have the motions from there that they had
         * @throws IllegalOperationError if the collision system has searched another list
         */
        public function write(search:CollisionSearch, list:Vector.<Agent>, keepsMotions:Boolean):ByteArray
        {
            var agents:int = list.length;
            var pairs:int = search == null ? 0 : _tracker.count;
            if (search != null && !search.isListed(list))
            {
                throw new IllegalOperationError("the collision system has searched another list since the last frame");
            }
            var names:ByteArray = namesOf(pairs);
            _bytes = newBytes();
            _bytes.length = AGENTS_AT + BYTES_PER_AGENT * agents + names.length + 4 + BYTES_PER_PAIR * pairs + SnapshotAgents.lengthOf(agents);
            _bytes.writeUnsignedInt(MARK);
            _bytes.writeInt(agents);
            var places:Vector.<int> = search == null ? null : search.writePositions(_bytes, keepsMotions);
            _bytes.writeBytes(names);
            _bytes.writeInt(pairs);
            writePairs(pairs, search, places);
            _who.write(_bytes, list);
            _bytes.position = 0;
            return _bytes;
        }

        /**
         * Reads what <code>write()</code> has written: the pairs into the tracker, which has none. Positions are looked at alone.
         *
         * @param agents each once, none null
         * @throws ArgumentError for bytes that are no record, or a record of other agents
         */
        public function read(agents:Vector.<Agent>):void
        {
            var count:int = readCount();
            if (count >= 0)
            {
                _bytes.position = _bytes.length - SnapshotAgents.lengthOf(count);
                _who.check(_bytes, count, agents);
                _bytes.position = AGENTS_AT;
            }
            if (count < 0 || !readPositions(count) || !readNames() || !readPairs(agents))
            {
                throw new ArgumentError("bytes are no snapshot of " + agents.length + " agents");
            }
        }

        // How many agents a record is of that is long enough for them; else -1.
        private function readCount():int
        {
            if (_bytes.length < AGENTS_AT || _bytes.readUnsignedInt() != MARK)
            {
                return -1;
            }
            var count:int = _bytes.readInt();
            var mostAgents:int = (_bytes.length - AGENTS_AT) / BYTES_PER_AGENT;
            return count <= mostAgents && _bytes.length >= AGENTS_AT + BYTES_PER_AGENT * count + SnapshotAgents.lengthOf(count) ? count : -1;
        }

        private function writePairs(pairs:int, search:CollisionSearch, places:Vector.<int>):void
        {
            var bytes:ByteArray = _bytes;
            for (var i:int = 0; i < pairs; i++)
            {
                var pair:ContactPair = _tracker.pairAt(i);
                var first:int = search.rowOf(pair.first);
                var second:int = search.rowOf(pair.second);
                bytes.writeInt(places[first]);
                bytes.writeInt(places[second]);
                bytes.writeInt(numberOf(Breeds.nameOf(pair.firstBreed)));
                bytes.writeInt(numberOf(Breeds.nameOf(pair.secondBreed)));
                bytes.writeBoolean(pair.isBothWays);
            }
        }

        private function namesOf(pairs:int):ByteArray
        {
            for (var i:int = 0; i < pairs; i++)
            {
                numberOf(Breeds.nameOf(_tracker.pairAt(i).firstBreed));
                numberOf(Breeds.nameOf(_tracker.pairAt(i).secondBreed));
            }
            var names:ByteArray = newBytes();
            names.writeInt(_breeds.length);
            for (i = 0; i < _breeds.length; i++)
            {
                var name:ByteArray = newBytes();
                name.writeUTFBytes(_breeds[i]);
                names.writeInt(name.length);
                names.writeBytes(name);
            }
            return names;
        }

        private function numberOf(breed:String):int
        {
            if (_lastBreed < 0 || _breeds[_lastBreed] != breed)
            {
                _lastBreed = _breeds.indexOf(breed);
                if (_lastBreed < 0)
                {
                    _lastBreed = _breeds.push(breed) - 1;
                }
            }
            return _lastBreed;
        }

        private function readPositions(agents:int):Boolean
        {
            var bytes:ByteArray = _bytes;
            for (var i:int = 0; i < agents; i++)
            {
                if (bytes.readUnsignedByte() > 1 || !isCoordinate(bytes.readDouble()) || !isCoordinate(bytes.readDouble())
                        || !isCoordinate(bytes.readDouble()))
                {
                    return false;
                }
            }
            return true;
        }

        private function readNames():Boolean
        {
            if (_bytes.bytesAvailable < 4)
            {
                return false;
            }
            var left:int = _bytes.readInt();
            while (left > 0 && _bytes.bytesAvailable >= 4)
            {
                var length:uint = _bytes.readUnsignedInt();
                if (length == 0 || length > _bytes.bytesAvailable)
                {
                    return false;
                }
                _breeds.push(_bytes.readUTFBytes(length));
                left--;
            }
            return left == 0;
        }

        private function readPairs(agents:Vector.<Agent>):Boolean
        {
            var bytes:ByteArray = _bytes;
            if (bytes.bytesAvailable < 4)
            {
                return false;
            }
            var pairs:int = bytes.readInt();
            if (pairs < 0 || bytes.bytesAvailable != BYTES_PER_PAIR * pairs + SnapshotAgents.lengthOf(agents.length))
            {
                return false;
            }
            var count:int = agents.length;
            var breeds:Vector.<String> = _breeds;
            for (var i:int = 0; i < pairs; i++)
            {
                var first:int = bytes.readInt();
                var second:int = bytes.readInt();
                var firstBreed:int = bytes.readInt();
                var secondBreed:int = bytes.readInt();
                var flag:int = bytes.readUnsignedByte();
                if (!isBelow(first, count) || !isBelow(second, count) || first == second || flag > 1
                        || !isBelow(firstBreed, breeds.length) || !isBelow(secondBreed, breeds.length)
                        || !_tracker.resume(agents[first], agents[second], Breeds.numberOf(breeds[firstBreed]), Breeds.numberOf(breeds[secondBreed]), flag == 1))
                {
                    return false;
                }
            }
            return true;
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

        private static function isBelow(value:int, end:int):Boolean
        {
            return value >= 0 && value < end;
        }
    }
}
