package starlogo.collision
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.handlers.ContactTracker;
    import starlogo.search.CollisionSearch;

    /** Writes and reads the snapshots of one Collision. */
    internal final class Snapshots
    {
        // As many as leave a whole number that a Number holds exactly.
        private static const COUNTS:int = 4096;

        private static var sCount:int = 0;

        // Tells this Collision's snapshots from those of all others: in this program by the count, elsewhere by the clock.
        private var _origin:Number;

        // Takes what is read; empty in between.
        private var _read:ContactTracker = new ContactTracker();

        /** No snapshot has been taken yet. */
        public function Snapshots()
        {
            sCount++;
            _origin = new Date().getTime() * COUNTS + sCount % COUNTS;
        }

        /** The bytes of a snapshot; parameters as for FrameRecord. */
        public function write(tracker:ContactTracker, search:CollisionSearch, agents:Vector.<Agent>, keepsMotions:Boolean):ByteArray
        {
            return new FrameRecord(tracker, new SnapshotAgents(_origin)).write(search, agents, keepsMotions);
        }

        /**
         * Makes the positions of a snapshot those of the last search.
         *
         * @param tracker knows which pairs touch now; it is empty afterwards, and used in the next call
         * @return what knows which pairs touched then
         * @throws ArgumentError as Collision.restore does; nothing has changed then
         */
        public function read(bytes:ByteArray, agents:Vector.<Agent>, search:CollisionSearch, tracker:ContactTracker):ContactTracker
        {
            var position:uint = bytes.position;
            var endian:String = bytes.endian;
            var found:ContactTracker = _read;
            bytes.position = 0;
            bytes.endian = Endian.LITTLE_ENDIAN;
            try
            {
                search.check(agents);
                new FrameRecord(found, new SnapshotAgents(_origin), bytes).read(agents);
                bytes.position = FrameRecord.AGENTS_AT;
                search.restorePositions(agents, bytes);
                _read = tracker;
            }
            finally
            {
                _read.clear();
                bytes.position = position;
                bytes.endian = endian;
            }
            return found;
        }
    }
}
