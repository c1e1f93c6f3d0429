package starlogo.agents
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Trigonometry;

    use namespace engine;

    /**
     * What an agent stands on since its last walk, and where both were when it ended. If the platform has moved and turned since, this says how far
     * the agent is carried.
     *
     * @private
     */
    public final class PlatformLink
    {
        /** The agent that has walked. */
        public var agent:Agent;

        /** The agent that it stands on. It is null if the agent stands on nothing, or on the ground. */
        public var platform:Agent = null;

        /** Where the platform was. */
        public var platformPlace:Placement = new Placement();

        /** The revision that the platform had. */
        public var platformRevision:int = 0;

        /** Where the agent itself was. */
        public var place:Vector3D = new Vector3D();

        /** @param agent the agent that walks */
        public function PlatformLink(agent:Agent)
        {
            this.agent = agent;
        }

        /** Notes what the agent stands on. */
        public function setTo(platform:Agent, platformPlace:Placement, platformRevision:int):void
        {
            this.platform = platform;
            this.platformPlace.copyFrom(platformPlace);
            this.platformRevision = platformRevision;
            place.setTo(agent.placement.x, agent.placement.y, agent.placement.z);
        }

        /** Whether the agent is still where it was, and the platform has not jumped. */
        public function get isValid():Boolean
        {
            return platform != null && platform.jumpRevision <= platformRevision
                && agent.placement.x == place.x && agent.placement.y == place.y && agent.placement.z == place.z;
        }

        /**
         * Finds how the agent is carried.
         *
         * @param to where the platform is now
         * @param motion receives the motion of the agent
         * @return the turn about the z axis, in degrees
         */
        public function carry(to:Placement, motion:Vector3D):Number
        {
            var from:Placement = platformPlace;
            var toX:Number = place.x - from.x;
            var toY:Number = place.y - from.y;
            var toZ:Number = place.z - from.z;
            motion.setTo(to.x - from.x, to.y - from.y, to.z - from.z);
            if (from.size == to.size && from.hasRotationOf(to))
            {
                return 0;
            }
            var scale:Number = to.size / from.size;
            var alongX:Number = scale * (from.r00 * toX + from.r10 * toY + from.r20 * toZ);
            var alongY:Number = scale * (from.r01 * toX + from.r11 * toY + from.r21 * toZ);
            var alongZ:Number = scale * (from.r02 * toX + from.r12 * toY + from.r22 * toZ);
            motion.x += to.r00 * alongX + to.r01 * alongY + to.r02 * alongZ - toX;
            motion.y += to.r10 * alongX + to.r11 * alongY + to.r12 * alongZ - toY;
            motion.z += to.r20 * alongX + to.r21 * alongY + to.r22 * alongZ - toZ;
            return Trigonometry.arctangent(to.r10 * from.r00 + to.r11 * from.r01 + to.r12 * from.r02
                    - to.r00 * from.r10 - to.r01 * from.r11 - to.r02 * from.r12,
                    to.r00 * from.r00 + to.r01 * from.r01 + to.r02 * from.r02 + to.r10 * from.r10 + to.r11 * from.r11 + to.r12 * from.r12);
        }
    }
}
