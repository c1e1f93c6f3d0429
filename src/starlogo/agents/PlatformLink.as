package starlogo.agents
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * What an agent stands on since its last walk, and where both were when it ended. If the platform has moved and turned since, the next walk begins
     * where it carries the agent.
     *
     * @private
     */
    public final class PlatformLink
    {
        /** The agent that has walked. */
        public var agent:Agent;

        /** The agent that it stands on. It is null if the agent stands on nothing, or on the ground. */
        public var platform:Agent = null;

        /** Where the platform was, with its own rotation, also if that did not count: see ModelShape.ignoresRotation. */
        public var platformPlacement:Placement = new Placement();

        /** The revision that the platform had. */
        public var platformRevision:int = 0;

        /** Where the agent itself was. */
        public var walkerPlace:Vector3D = new Vector3D();

        /** @param agent the agent that walks */
        public function PlatformLink(agent:Agent)
        {
            this.agent = agent;
        }

        /** Notes what the agent stands on. */
        public function setTo(platform:Agent, platformPlacement:Placement, platformRevision:int):void
        {
            this.platform = platform;
            this.platformPlacement.copyFrom(platformPlacement);
            this.platformRevision = platformRevision;
            walkerPlace.setTo(agent.placement.x, agent.placement.y, agent.placement.z);
        }

        /** Whether the agent is still where it was, and the platform has not jumped. */
        public function get isValid():Boolean
        {
            var place:Placement = agent.placement;
            return platform != null && platform.jumpRevision <= platformRevision
                && isSame(place.x, walkerPlace.x) && isSame(place.y, walkerPlace.y) && isSame(place.z, walkerPlace.z);
        }

        // Whether two coordinates of the agent are the same, up to the rounding of a game that keeps them from another point of the agent.
        private function isSame(a:Number, b:Number):Boolean
        {
            return Math.abs(a - b) <= Tolerances.UNIT_ROUNDING * (Math.abs(b) + agent.size);
        }
    }
}
