package starlogo.collision.snapshots
{
    import starlogo.agents.Agent;

    /** What a SnapshotRegister remembers of a snapshot. A record. */
    internal final class SnapshotEntry
    {
        /** The hash of the bytes. */
        public var hash:int;

        /** The number of bytes. */
        public var length:uint;

        /** How many agents had been created. */
        public var createdCount:int;

        /** The ids of the agents. */
        public var ids:Vector.<int> = new Vector.<int>();

        /** The agents of the ground and of the edges that were exchanged before; null if none were. */
        public var formerEnvironment:Vector.<Agent>;
    }
}
