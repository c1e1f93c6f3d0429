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
        /** The agent that the walker stands on. It is null if the walker stands on nothing, or on the ground. */
        public var platform:Agent = null;

        /** Where the platform was, with its own rotation, also if that did not count: see ModelShape.ignoresRotation. */
        public var platformPlacement:Placement = new Placement();

        /** The revision that the platform had. */
        public var platformRevision:int = 0;

        /** Where the walker was. */
        public var walkerPlace:Vector3D = new Vector3D();

        /** Notes what a walker stands on. */
        public function setTo(walker:Agent, platform:Agent, platformPlacement:Placement, platformRevision:int):void
        {
            this.platform = platform;
            this.platformPlacement.copyFrom(platformPlacement);
            this.platformRevision = platformRevision;
            walkerPlace.setTo(walker.placement.x, walker.placement.y, walker.placement.z);
        }

        /** Whether the platform may carry the walker, if that is where it was: there is one, and it has not jumped since. */
        public function get hasPlatform():Boolean
        {
            return platform != null && platform.jumpRevision <= platformRevision;
        }

        /** Whether the platform carries the walker: the walker is still where it was. */
        public function carries(walker:Agent):Boolean
        {
            var at:Placement = walker.placement;
            return hasPlatform && isSame(at.x, walkerPlace.x, at.size) && isSame(at.y, walkerPlace.y, at.size) && isSame(at.z, walkerPlace.z, at.size);
        }

        // Whether two coordinates of the walker are the same, up to the rounding of a game that keeps them from another point of the walker.
        private static function isSame(a:Number, b:Number, size:Number):Boolean
        {
            return Math.abs(a - b) <= Tolerances.UNIT_ROUNDING * (Math.abs(b) + size);
        }
    }
}
