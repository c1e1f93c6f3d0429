package starlogo.collision
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Tells which agents a snapshot is of, so that another list is refused. The Collision that took it wants the very same agents, or others that
     * were made since, as when a game is read from a file. Another Collision takes any others: ids say nothing there.
     *
     * @private
     */
    public final class SnapshotAgents
    {
        // So few that an origin is a whole number that a Number holds exactly.
        private static const COUNTS:int = 4096;

        // The bytes of the origin, and of how many agents there were.
        private static const HEAD:int = 12;
        private static const BYTES_PER_ID:int = 4;
        private static const NAMED:int = 10;

        private static var sCount:int = 0;

        // Tells this Collision's snapshots from those of all others: in this program by the count, elsewhere by the clock.
        private var _origin:Number;

        /** For the snapshots of a new Collision. */
        public function SnapshotAgents()
        {
            sCount++;
            _origin = new Date().getTime() * COUNTS + sCount % COUNTS;
        }

        /** How many bytes the ids of so many agents take. */
        public static function lengthOf(agents:int):int
        {
            return HEAD + BYTES_PER_ID * agents;
        }

        /** Writes which agents they are. */
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
         * @param count how many agents the snapshot is of
         * @throws ArgumentError if the list is another one
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
