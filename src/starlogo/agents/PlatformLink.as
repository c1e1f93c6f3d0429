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
         * @param now where the platform is now
         * @param motion receives the motion of the agent
         * @return the turn about the z axis, in degrees
         */
        public function carry(now:Placement, motion:Vector3D):Number
        {
            var from:Placement = platformPlace;
            var offsetX:Number = place.x - from.x;
            var offsetY:Number = place.y - from.y;
            var offsetZ:Number = place.z - from.z;
            motion.setTo(now.x - from.x, now.y - from.y, now.z - from.z);
            if (from.size == now.size && from.hasRotationOf(now))
            {
                return 0;
            }
            var scale:Number = now.size / from.size;
            var alongX:Number = scale * (from.r00 * offsetX + from.r10 * offsetY + from.r20 * offsetZ);
            var alongY:Number = scale * (from.r01 * offsetX + from.r11 * offsetY + from.r21 * offsetZ);
            var alongZ:Number = scale * (from.r02 * offsetX + from.r12 * offsetY + from.r22 * offsetZ);
            motion.x += now.r00 * alongX + now.r01 * alongY + now.r02 * alongZ - offsetX;
            motion.y += now.r10 * alongX + now.r11 * alongY + now.r12 * alongZ - offsetY;
            motion.z += now.r20 * alongX + now.r21 * alongY + now.r22 * alongZ - offsetZ;
            return Trigonometry.arctangent(now.r10 * from.r00 + now.r11 * from.r01 + now.r12 * from.r02
                    - now.r00 * from.r10 - now.r01 * from.r11 - now.r02 * from.r12,
                    now.r00 * from.r00 + now.r01 * from.r01 + now.r02 * from.r02 + now.r10 * from.r10 + now.r11 * from.r11 + now.r12 * from.r12);
        }
    }
}
