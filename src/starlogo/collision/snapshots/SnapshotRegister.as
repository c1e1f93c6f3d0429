package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Remembers which agents the last snapshots of a Collision belong to, so that restoring to another list is refused. It finds a snapshot by
     * a hash of its bytes, because the bytes themselves hold no ids: machines in step write the same bytes. It accepts the same agents, or
     * agents that were all created since, as when a game is read from a file. It accepts any agents for bytes that it does not remember,
     * because ids mean nothing elsewhere.
     *
     * @private
     */
    public final class SnapshotRegister
    {
        // How many ids are remembered, unless the last snapshot alone has more.
        private static const MOST_IDS:int = 65536;

        // How many ids an error names.
        private static const NAMED:int = 10;

        // What an entry begins with. The ids of the agents follow.
        private static const HASH:int = 0;
        private static const LENGTH:int = 1;
        private static const CREATED_COUNT:int = 2;
        private static const HEAD:int = 3;

        // The entries, the oldest first, and how many numbers they have together.
        private var _entries:Vector.<Vector.<int>> = new Vector.<Vector.<int>>();
        private var _size:int = 0;

        /** Remembers a snapshot of these agents. */
        public function note(bytes:ByteArray, agents:Vector.<Agent>):void
        {
            var entry:Vector.<int> = new <int>[hashOf(bytes), bytes.length, Agent.createdCount];
            for (var i:int = 0; i < agents.length; i++)
            {
                entry.push(agents[i].idNumber);
            }
            _entries.push(entry);
            _size += entry.length;
            while (_size > MOST_IDS && _entries.length > 1)
            {
                _size -= _entries.shift().length;
            }
        }

        /**
         * Compares a list with the agents of a snapshot.
         *
         * @param count the number of agents of the snapshot
         * @throws ArgumentError if the list has another length, or the snapshot is remembered and has other agents
         */
        public function check(bytes:ByteArray, count:int, agents:Vector.<Agent>):void
        {
            var hash:int = hashOf(bytes);
            var known:Vector.<int> = null;
            for (var i:int = _entries.length - 1; i >= 0; i--)
            {
                var entry:Vector.<int> = _entries[i];
                if (entry[HASH] == hash && entry[LENGTH] == bytes.length && entry.length == HEAD + count)
                {
                    known = entry;
                    if (count == agents.length && firstOther(entry, agents) < 0)
                    {
                        return;
                    }
                }
            }
            if (count != agents.length)
            {
                throw new ArgumentError("bytes are no snapshot of " + agents.length + " agents, but of " + wanted(count, known));
            }
            if (known != null)
            {
                var other:int = firstOther(known, agents);
                throw new ArgumentError("bytes are no snapshot of these " + count + " agents, but of " + wanted(count, known) + "; at place " + other
                        + " the list has " + agents[other]);
            }
        }

        // The index of the first agent that is another than the entry's; -1 if none is, or if all were created since.
        private static function firstOther(entry:Vector.<int>, agents:Vector.<Agent>):int
        {
            var areNew:Boolean = true;
            var other:int = -1;
            for (var i:int = agents.length - 1; i >= 0; i--)
            {
                var id:int = agents[i].idNumber;
                areNew = areNew && id > entry[CREATED_COUNT];
                other = id == entry[HEAD + i] ? other : i;
            }
            return areNew ? -1 : other;
        }

        private static function hashOf(bytes:ByteArray):int
        {
            var positionBefore:uint = bytes.position;
            var hash:int = 0;
            bytes.position = 0;
            while (bytes.bytesAvailable >= 4)
            {
                hash = (hash << 5) - hash + bytes.readInt();
                hash ^= hash >>> 15;
            }
            while (bytes.bytesAvailable > 0)
            {
                hash = (hash << 5) - hash + bytes.readUnsignedByte();
            }
            bytes.position = positionBefore;
            return hash;
        }

        private static function wanted(count:int, known:Vector.<int>):String
        {
            var all:String = "the " + count + " that its frame's collision.lastAgents had";
            if (count == 0)
            {
                return "no agents: it was taken before the first frame, or after a frame without agents";
            }
            if (known == null)
            {
                return all;
            }
            var more:String = count > NAMED ? " and " + (count - NAMED) + " more" : "";
            return all + ": those with the ids " + known.slice(HEAD, HEAD + NAMED).join(", ") + more;
        }
    }
}
