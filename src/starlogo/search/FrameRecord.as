package starlogo.search
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;

    /**
     * What the next frame depends on besides the agents: where the last one saw them, and which pairs touched. Agents are numbers, their
     * places in the last frame's list.
     *
     * <p>As bytes: a mark; how many agents; of each whether it has a motion from where it was seen, and its place; how many names of breeds, and
     * the names; how many pairs, and of each its agents, their breeds, and whether it touches both ways.</p>
     *
     * @private
     */
    public final class FrameRecord
    {
        // "SLF1"
        private static const MARK:uint = 0x534C4631;
        private static const BYTES_PER_AGENT:int = 25;
        private static const BYTES_PER_PAIR:int = 17;

        /** How many agents there are. */
        public var count:int = 0;

        /** Whether the next frame takes an agent to have moved from where it was. */
        public var hasMotion:Vector.<Boolean>;

        /** Where an agent was. */
        public var x:Vector.<Number>;

        /** @copy #x */
        public var y:Vector.<Number>;

        /** @copy #x */
        public var z:Vector.<Number>;

        /** How many pairs touch. */
        public var pairCount:int = 0;

        /** The agent that was first when a pair's contact began. */
        public var first:Vector.<int>;

        /** The other one. */
        public var second:Vector.<int>;

        /** The breed that the first had when it began, of <code>breeds</code>. */
        public var firstBreed:Vector.<int>;

        /** The breed of the other one then. */
        public var secondBreed:Vector.<int>;

        /** Whether the contact has begun in both directions. */
        public var isBothWays:Vector.<Boolean>;

        /** The names of breeds. */
        public var breeds:Vector.<String> = new Vector.<String>();

        private var _lastBreed:int = -1;

        /** Of no agents and no pairs. */
        public function FrameRecord()
        {
            beginAgents(0);
            beginPairs(0);
        }

        /** Has a number of agents, of which nothing is known yet. */
        public function beginAgents(agents:int):void
        {
            count = agents;
            hasMotion = new Vector.<Boolean>(agents, true);
            x = new Vector.<Number>(agents, true);
            y = new Vector.<Number>(agents, true);
            z = new Vector.<Number>(agents, true);
        }

        /** Has room for a number of pairs. */
        public function beginPairs(pairs:int):void
        {
            pairCount = 0;
            first = new Vector.<int>(pairs, true);
            second = new Vector.<int>(pairs, true);
            firstBreed = new Vector.<int>(pairs, true);
            secondBreed = new Vector.<int>(pairs, true);
            isBothWays = new Vector.<Boolean>(pairs, true);
        }

        /** Adds a pair that touches. */
        public function addPair(firstAgent:int, secondAgent:int, breedOfFirst:String, breedOfSecond:String, touchesBothWays:Boolean):void
        {
            first[pairCount] = firstAgent;
            second[pairCount] = secondAgent;
            firstBreed[pairCount] = numberOf(breedOfFirst);
            secondBreed[pairCount] = numberOf(breedOfSecond);
            isBothWays[pairCount] = touchesBothWays;
            pairCount++;
        }

        /** Has no agent moved from where it was. */
        public function forgetMotions():void
        {
            for (var i:int = 0; i < count; i++)
            {
                hasMotion[i] = false;
            }
        }

        /** Writes all. */
        public function toBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.length = 8 + BYTES_PER_AGENT * count;
            bytes.writeUnsignedInt(MARK);
            bytes.writeInt(count);
            for (var i:int = 0; i < count; i++)
            {
                bytes.writeBoolean(hasMotion[i]);
                bytes.writeDouble(x[i]);
                bytes.writeDouble(y[i]);
                bytes.writeDouble(z[i]);
            }
            bytes.writeInt(breeds.length);
            for (i = 0; i < breeds.length; i++)
            {
                var name:ByteArray = new ByteArray();
                name.writeUTFBytes(breeds[i]);
                bytes.writeInt(name.length);
                bytes.writeBytes(name);
            }
            bytes.writeInt(pairCount);
            bytes.length += BYTES_PER_PAIR * pairCount;
            for (i = 0; i < pairCount; i++)
            {
                bytes.writeInt(first[i]);
                bytes.writeInt(second[i]);
                bytes.writeInt(firstBreed[i]);
                bytes.writeInt(secondBreed[i]);
                bytes.writeBoolean(isBothWays[i]);
            }
            bytes.position = 0;
            return bytes;
        }

        /**
         * Reads what toBytes has written.
         *
         * @param bytes as a whole; its position and endianness stay as they are
         * @param agentCount how many agents there are to be
         * @return null for bytes that are no record, or a record of another number of agents
         */
        public static function fromBytes(bytes:ByteArray, agentCount:int):FrameRecord
        {
            var position:uint = bytes.position;
            var endian:String = bytes.endian;
            bytes.position = 0;
            bytes.endian = Endian.LITTLE_ENDIAN;
            var record:FrameRecord = new FrameRecord();
            var isRight:Boolean = record.readAgents(bytes, agentCount) && record.readNames(bytes) && record.readPairs(bytes);
            bytes.position = position;
            bytes.endian = endian;
            return isRight ? record : null;
        }

        private function numberOf(breed:String):int
        {
            if (_lastBreed < 0 || breeds[_lastBreed] != breed)
            {
                _lastBreed = breeds.indexOf(breed);
                if (_lastBreed < 0)
                {
                    _lastBreed = breeds.push(breed) - 1;
                }
            }
            return _lastBreed;
        }

        private function readAgents(bytes:ByteArray, agentCount:int):Boolean
        {
            if (bytes.length < 8 || bytes.readUnsignedInt() != MARK || bytes.readInt() != agentCount
                    || bytes.bytesAvailable < BYTES_PER_AGENT * agentCount)
            {
                return false;
            }
            beginAgents(agentCount);
            for (var i:int = 0; i < count; i++)
            {
                var flag:int = bytes.readUnsignedByte();
                hasMotion[i] = flag == 1;
                x[i] = bytes.readDouble();
                y[i] = bytes.readDouble();
                z[i] = bytes.readDouble();
                if (flag > 1 || !isCoordinate(x[i]) || !isCoordinate(y[i]) || !isCoordinate(z[i]))
                {
                    return false;
                }
            }
            return true;
        }

        private function readNames(bytes:ByteArray):Boolean
        {
            if (bytes.bytesAvailable < 4)
            {
                return false;
            }
            var left:int = bytes.readInt();
            while (left > 0 && bytes.bytesAvailable >= 4)
            {
                var length:uint = bytes.readUnsignedInt();
                if (length == 0 || length > bytes.bytesAvailable)
                {
                    return false;
                }
                breeds.push(bytes.readUTFBytes(length));
                left--;
            }
            return left == 0;
        }

        private function readPairs(bytes:ByteArray):Boolean
        {
            if (bytes.bytesAvailable < 4)
            {
                return false;
            }
            var pairs:int = bytes.readInt();
            if (pairs < 0 || bytes.bytesAvailable != BYTES_PER_PAIR * pairs)
            {
                return false;
            }
            beginPairs(pairs);
            // by the lower agent of a pair: the last pair that has it, and of each pair the one before
            var last:Vector.<int> = new Vector.<int>(count, true);
            var before:Vector.<int> = new Vector.<int>(pairs, true);
            for (var i:int = 0; i < pairs; i++)
            {
                var a:int = bytes.readInt();
                var b:int = bytes.readInt();
                var breedOfA:int = bytes.readInt();
                var breedOfB:int = bytes.readInt();
                var flag:int = bytes.readUnsignedByte();
                if (!isBelow(a, count) || !isBelow(b, count) || a == b || flag > 1
                        || !isBelow(breedOfA, breeds.length) || !isBelow(breedOfB, breeds.length))
                {
                    return false;
                }
                var lower:int = a < b ? a : b;
                for (var other:int = last[lower]; other > 0; other = before[other - 1])
                {
                    if (first[other - 1] + second[other - 1] == a + b)
                    {
                        return false;
                    }
                }
                before[i] = last[lower];
                last[lower] = i + 1;
                first[i] = a;
                second[i] = b;
                firstBreed[i] = breedOfA;
                secondBreed[i] = breedOfB;
                isBothWays[i] = flag == 1;
                pairCount++;
            }
            return true;
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
