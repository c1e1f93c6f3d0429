package starlogo.collision.snapshots
{
    import starlogo.agents.PlatformLink;
    import starlogo.ground.HeightGrid;
    import starlogo.handlers.TouchTracker;

    /** What was read of a snapshot: all but the traits of agents, which are not known to be right before an agent has taken them. A record. */
    internal final class SnapshotParts
    {
        /** Whether traits follow. */
        public var hasTraits:Boolean = false;

        /** The names. */
        public var names:SnapshotNames = new SnapshotNames();

        /** The places of the agents. */
        public var places:SnapshotPlaces = null;

        /** The touching pairs. */
        public var touches:TouchTracker = null;

        /** What agents stand on. */
        public var platforms:Vector.<PlatformLink> = null;

        /** A grid with the heights of the ground, or null. */
        public var ground:HeightGrid = null;
    }
}
