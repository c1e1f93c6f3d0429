package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Remembers which agents the last snapshots of a Collision belong to, so that restoring to another list is refused, and the agents of the
     * ground and the edges that were exchanged before each. It finds a snapshot by a hash of its bytes, because the bytes themselves hold no
     * ids: machines in step write the same bytes. It accepts the same agents, or agents that were all created since, as when a game is read
     * from a file. It accepts any agents for bytes that it does not remember, because ids mean nothing elsewhere.
     *
     * @private
     */
    public final class SnapshotRegister
    {
        // How many snapshots are remembered.
        private static const MAX_ENTRIES:int = 256;

        // How many ids an error names.
        private static const MAX_NAMED_IDS:int = 10;

        // The entries, the oldest first.
        private var _entries:Vector.<SnapshotEntry> = new Vector.<SnapshotEntry>();

        /**
         * Remembers a snapshot of these agents.
         *
         * @param formerEnvironment the agents of the ground and of the edges that were exchanged before; null if none were
         */
        public function note(bytes:ByteArray, agents:Vector.<Agent>, formerEnvironment:Vector.<Agent>):void
        {
            var entry:SnapshotEntry = new SnapshotEntry();
            entry.hash = hashOf(bytes);
            entry.createdCount = Agent.createdCount;
            entry.formerEnvironment = formerEnvironment;
            for (var i:int = 0; i < agents.length; i++)
            {
                entry.ids.push(agents[i].idNumber);
            }
            if (_entries.push(entry) > MAX_ENTRIES)
            {
                _entries.shift();
            }
        }

        /**
         * Refuses a list that has not the agents of a snapshot. Returns the <code>formerEnvironment</code> that <code>note()</code> got; null if none
         * was exchanged, or if the snapshot is not remembered.
         *
         * @param count the number of agents of the snapshot
         * @throws ArgumentError if the list has another length, or the snapshot is remembered and has other agents
         */
        public function recallFormerEnvironment(bytes:ByteArray, count:int, agents:Vector.<Agent>):Vector.<Agent>
        {
            var hash:int = hashOf(bytes);
            var known:SnapshotEntry = null;
            for (var i:int = _entries.length - 1; i >= 0; i--)
            {
                var entry:SnapshotEntry = _entries[i];
                if (entry.hash == hash && entry.ids.length == count)
                {
                    known = entry;
                    if (count == agents.length && firstOther(entry, agents) < 0)
                    {
                        return entry.formerEnvironment;
                    }
                }
            }
            if (count != agents.length)
            {
                throw new ArgumentError("bytes are no snapshot of " + agents.length + " agents, but of " + textOfAgents(count, known));
            }
            if (known != null)
            {
                var other:int = firstOther(known, agents);
                throw new ArgumentError("bytes are no snapshot of these " + count + " agents, but of " + textOfAgents(count, known) + "; at place " + other
                        + " the list has " + agents[other]);
            }
            return null;
        }

        // The index of the first agent that is another than the entry's; -1 if none is, or if all were created since.
        private static function firstOther(entry:SnapshotEntry, agents:Vector.<Agent>):int
        {
            var areNew:Boolean = true;
            var other:int = -1;
            for (var i:int = 0; i < agents.length; i++)
            {
                var id:int = agents[i].idNumber;
                areNew = areNew && id > entry.createdCount;
                if (other < 0 && id != entry.ids[i])
                {
                    other = i;
                }
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

        private static function textOfAgents(count:int, known:SnapshotEntry):String
        {
            var all:String = "the " + count + " that its frame's collision.lastAgents had, of which a game keeps a copy";
            if (count == 0)
            {
                return "no agents: it was taken before the first frame, or after a frame without agents";
            }
            if (known == null)
            {
                return all;
            }
            var more:String = count > MAX_NAMED_IDS ? " and " + (count - MAX_NAMED_IDS) + " more" : "";
            return all + ": those with the ids " + known.ids.slice(0, MAX_NAMED_IDS).join(", ") + more;
        }
    }
}

import starlogo.agents.Agent;

/** What is remembered of a snapshot. A record. */
final class SnapshotEntry
{
    /** The hash of the bytes. */
    public var hash:int;

    /** How many agents had been created. */
    public var createdCount:int;

    /** The ids of the agents. */
    public var ids:Vector.<int> = new Vector.<int>();

    /** The agents of the ground and of the edges that were exchanged before; null if none were. */
    public var formerEnvironment:Vector.<Agent>;
}
