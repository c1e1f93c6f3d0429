package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.handlers.ContactPair;
    import starlogo.handlers.ContactTracker;
    import starlogo.search.CollisionSearch;

    /**
     * What the next frame depends on besides the agents, as bytes: where the last one saw them, and which pairs touched. Agents are numbers,
     * their places in the last frame's list.
     *
     * <p>The bytes: a mark; how many agents; of each whether it has a motion from where it was seen, and its place; how many names of breeds, and
     * the names; how many pairs, and of each its agents, their breeds, and whether it touches both ways.</p>
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
        private var _bytes:ByteArray;
        private var _breeds:Vector.<String> = new Vector.<String>();
        private var _lastBreed:int = -1;

        /**
         * @param tracker knows which pairs touch
         * @param bytes to be read, at their beginning and little-endian
         */
        public function FrameRecord(tracker:ContactTracker, bytes:ByteArray = null)
        {
            _tracker = tracker;
            _bytes = bytes;
        }

        /**
         * Writes all.
         *
         * @param search of the last frame; null if there was none
         * @param keepsMotions whether agents have the motions from there that they had
         * @throws IllegalOperationError if one agent of a pair was not in the last search
         */
        public function write(search:CollisionSearch, keepsMotions:Boolean):ByteArray
        {
            var agents:int = search == null ? 0 : search.count;
            var pairs:int = search == null ? 0 : _tracker.count;
            var names:ByteArray = namesOf(pairs);
            _bytes = newBytes();
            _bytes.length = AGENTS_AT + BYTES_PER_AGENT * agents + names.length + 4 + BYTES_PER_PAIR * pairs;
            _bytes.writeUnsignedInt(MARK);
            _bytes.writeInt(agents);
            var places:Vector.<int> = search == null ? null : search.writePositions(_bytes, keepsMotions);
            _bytes.writeBytes(names);
            _bytes.writeInt(pairs);
            writePairs(pairs, search, places);
            _bytes.position = 0;
            return _bytes;
        }

        /**
         * Reads what <code>write()</code> has written: the pairs into the tracker, which has none. Positions are looked at alone.
         *
         * @param agents each once, none null
         * @return false for bytes that are no record, or a record of another number of agents
         */
        public function read(agents:Vector.<Agent>):Boolean
        {
            return readPositions(agents.length) && readNames() && readPairs(agents);
        }

        private function writePairs(pairs:int, search:CollisionSearch, places:Vector.<int>):void
        {
            var bytes:ByteArray = _bytes;
            for (var i:int = 0; i < pairs; i++)
            {
                var pair:ContactPair = _tracker.pairAt(i);
                var first:int = search.rowOf(pair.first);
                var second:int = search.rowOf(pair.second);
                if (first < 0 || second < 0)
                {
                    throw new IllegalOperationError("the collision system has searched another list since the last frame");
                }
                bytes.writeInt(places[first]);
                bytes.writeInt(places[second]);
                bytes.writeInt(numberOf(pair.firstBreed));
                bytes.writeInt(numberOf(pair.secondBreed));
                bytes.writeBoolean(pair.isBothWays);
            }
        }

        private function namesOf(pairs:int):ByteArray
        {
            for (var i:int = 0; i < pairs; i++)
            {
                numberOf(_tracker.pairAt(i).firstBreed);
                numberOf(_tracker.pairAt(i).secondBreed);
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
            if (bytes.length < AGENTS_AT || bytes.readUnsignedInt() != MARK || bytes.readInt() != agents
                    || bytes.bytesAvailable < BYTES_PER_AGENT * agents)
            {
                return false;
            }
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
            if (pairs < 0 || bytes.bytesAvailable != BYTES_PER_PAIR * pairs)
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
                        || !_tracker.resume(agents[first], agents[second], breeds[firstBreed], breeds[secondBreed], flag == 1))
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
