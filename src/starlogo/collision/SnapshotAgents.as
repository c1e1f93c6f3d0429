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
        // The number of the Collision, and how many agents there were.
        private static const HEAD:int = 12;
        private static const BYTES_PER_ID:int = 4;
        private static const NAMED:int = 10;

        // Of agents.
        private var _ids:Vector.<int> = new Vector.<int>();
        private var _origin:Number;
        private var _created:int;

        /** @param origin the number of the Collision, which no other has, on no machine */
        public function SnapshotAgents(origin:Number)
        {
            _origin = origin;
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
         * @param bytes at the place where <code>write()</code> began
         * @param count how many agents the snapshot is of
         * @throws ArgumentError if the list is another one
         */
        public function check(bytes:ByteArray, count:int, agents:Vector.<Agent>):void
        {
            var isOwn:Boolean = bytes.readDouble() == _origin;
            _created = bytes.readInt();
            for (var i:int = 0; i < count; i++)
            {
                _ids[i] = bytes.readInt();
            }
            if (count != agents.length)
            {
                throw new ArgumentError("bytes are no snapshot of " + agents.length + " agents, but of " + wanted);
            }
            var other:int = isOwn ? firstOther(agents) : -1;
            if (other >= 0)
            {
                throw new ArgumentError("bytes are no snapshot of these " + count + " agents, but of " + wanted + "; at place " + other
                        + " the list has " + agents[other]);
            }
        }

        // The first place with another agent than the snapshot's; -1 if there is none, or all agents were made since.
        private function firstOther(agents:Vector.<Agent>):int
        {
            var first:int = -1;
            var areNew:Boolean = true;
            for (var i:int = agents.length - 1; i >= 0; i--)
            {
                areNew = areNew && agents[i].number > _created;
                if (agents[i].number != _ids[i])
                {
                    first = i;
                }
            }
            return areNew ? -1 : first;
        }

        private function get wanted():String
        {
            var named:String = _ids.slice(0, NAMED).join(", ");
            var more:String = _ids.length > NAMED ? " and " + (_ids.length - NAMED) + " more" : "";
            return "the " + _ids.length + " that its frame's collision.lastAgents had: those with the ids " + named + more;
        }
    }
}
