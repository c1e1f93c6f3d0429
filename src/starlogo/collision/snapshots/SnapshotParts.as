package starlogo.collision.snapshots
{
    import starlogo.handlers.TouchTracker;

    /** What is in a snapshot that is read, and where its parts begin. A record. */
    internal final class SnapshotParts
    {
        /** What is in it, as in Snapshots. */
        public var contents:int = 0;

        /** The names. */
        public var names:SnapshotNames = new SnapshotNames();

        /** The touching pairs. */
        public var touches:TouchTracker = new TouchTracker();

        /** Where the places begin. */
        public var placesAt:uint = 0;

        /** Where begins what agents stand on. */
        public var platformsAt:uint = 0;

        /** Where the heights of the ground begin. */
        public var groundAt:uint = 0;

        /** Where the traits begin. */
        public var traitsAt:uint = 0;
    }
}
