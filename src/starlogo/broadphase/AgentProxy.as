package starlogo.broadphase
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * An agent as the broad phase sees it: its extents in the world, and its place in the bins. Plain fields, because the
     * inner loops of a frame read them.
     *
     * @private
     */
    public class AgentProxy extends AgentRecord
    {
        /** The agent's revision that the extents belong to. */
        public var revision:int = -1;

        /** The placement's extentsRevision that they belong to. */
        public var extentsRevision:int = -1;

        /** Where the agent's model is, in its own hands. */
        public var placement:Placement;

        /** From the placement's position to the middle of the extents: stays while the agent only moves. */
        public var offsetX:Number = 0;

        /** @copy #offsetX */
        public var offsetY:Number = 0;

        /** @copy #offsetX */
        public var offsetZ:Number = 0;

        /** The middle of the extents. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** Half the extent along x, padded: Bins.fit says by how much. */
        public var reachX:Number;

        /** The same along y. */
        public var reachY:Number;

        /** The ground rectangle, padded: the least x. */
        public var minX:Number;

        /** The largest x. */
        public var maxX:Number;

        /** The least y. */
        public var minY:Number;

        /** The largest y. */
        public var maxY:Number;

        /** The level of the bins that it is entered in; null until Bins have assigned one. */
        public var level:BinLevel = null;

        /** Its entries for at most four bins, in a ring; the first is for the bin where its rectangle begins. */
        internal var entry:BinEntry;

        /** Whether what collides is a sphere about the middle: spares the most common test a call. */
        public var isSphere:Boolean = false;

        /** The sphere's radius, as wide as it must be for spheres to meet that touch but for rounding. */
        public var radius:Number;

        /** Half the extent along z, padded. */
        public var reachZ:Number;

        /** Half the extent along x. */
        public var halfX:Number;

        /** Half the extent along y. */
        public var halfY:Number;

        /** Half the extent along z. */
        public var halfZ:Number;

        /** The agent's id: settles the order of two proxies. */
        public var serial:int;

        /**
         * @param agent whose proxy it is
         * @param cacheToken that of the user who keeps it
         */
        public function AgentProxy(agent:Agent, cacheToken:CacheToken)
        {
            super(agent, cacheToken);
            placement = agent.placement;
            serial = agent.id;
            entry = BinEntry.ring(this);
        }
    }
}
