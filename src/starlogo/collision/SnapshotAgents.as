package starlogo.collision
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Tells which agents a snapshot belongs to, so that restoring to another list is refused. The Collision that took the snapshot accepts the same
     * agents, or agents that were all created since, as when a game is read from a file. Another Collision accepts any agents, because
     * ids mean nothing there.
     *
     * @private
     */
    public final class SnapshotAgents
    {
        // Small enough that a Number holds an origin exactly.
        private static const COUNTS:int = 4096;

        // The bytes of the origin and of the number of agents.
        private static const HEAD:int = 12;
        private static const BYTES_PER_ID:int = 4;
        private static const NAMED:int = 10;

        private static var sCount:int = 0;

        // Marks the snapshots of this Collision. The count differs between the Collisions of this program, and the clock between programs.
        private var _origin:Number;

        /** Creates it for a new Collision. */
        public function SnapshotAgents()
        {
            sCount++;
            _origin = new Date().getTime() * COUNTS + sCount % COUNTS;
        }

        /** Returns the bytes that the ids of this number of agents take. */
        public static function lengthOf(agents:int):int
        {
            return HEAD + BYTES_PER_ID * agents;
        }

        /** Writes the ids of the agents. */
        public function write(bytes:ByteArray, agents:Vector.<Agent>):void
        {
            bytes.writeDouble(_origin);
            bytes.writeInt(Agent.createdCount);
            for (var i:int = 0; i < agents.length; i++)
            {
                bytes.writeInt(agents[i].number);
            }
        }

        /**
         * Compares a list with the agents of a snapshot.
         *
         * @param bytes at the position where <code>write()</code> began
         * @param count the number of agents of the snapshot
         * @throws ArgumentError if the list has other agents
         */
        public function check(bytes:ByteArray, count:int, agents:Vector.<Agent>):void
        {
            var isOwn:Boolean = bytes.readDouble() == _origin;
            var created:int = bytes.readInt();
            var ids:Vector.<int> = new Vector.<int>();
            var other:int = -1;
            var areNew:Boolean = true;
            for (var i:int = 0; i < count; i++)
            {
                ids[i] = bytes.readInt();
                var number:int = i < agents.length ? agents[i].number : 0;
                areNew = areNew && number > created;
                other = other < 0 && number != ids[i] ? i : other;
            }
            if (count != agents.length)
            {
                throw new ArgumentError("bytes are no snapshot of " + agents.length + " agents, but of " + wanted(ids));
            }
            if (isOwn && !areNew && other >= 0)
            {
                throw new ArgumentError("bytes are no snapshot of these " + count + " agents, but of " + wanted(ids) + "; at place " + other
                        + " the list has " + agents[other]);
            }
        }

        private static function wanted(ids:Vector.<int>):String
        {
            var more:String = ids.length > NAMED ? " and " + (ids.length - NAMED) + " more" : "";
            return "the " + ids.length + " that its frame's collision.lastAgents had: those with the ids " + ids.slice(0, NAMED).join(", ") + more;
        }
    }
}
