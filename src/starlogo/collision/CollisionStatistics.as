package starlogo.collision
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.SearchCounts;

    use namespace engine;

    /**
     * What one frame of collision detection did and cost. The next frame overwrites it; copy the numbers to keep them.
     */
    public final class CollisionStatistics
    {
        private static const ZERO:CollisionStatistics = new CollisionStatistics();

        /** Agents in the list. */
        public var agents:int;

        /** Agents of breeds without handlers, and those that a Collision's filter excludes, which were skipped. */
        public var agentsSkipped:int;

        /** Agents whose models are still loading: they collide with nothing yet. */
        public var agentsLoading:int;

        /** Entries of agents in the thesis's bins: an agent that reaches into four of them counts four times. */
        public var binEntries:int;

        /** Pairs of agents whose circles on the ground overlap. */
        public var candidatePairs:int;

        /** Pairs in which an agent sweeps, and which came near each other: each was tested along its motion. */
        public var sweptPairs:int;

        /** Sphere-sphere tests. */
        public var sphereSphereTests:int;

        /** Sphere-capsule tests. */
        public var sphereCapsuleTests:int;

        /** Sphere-box tests. */
        public var sphereBoxTests:int;

        /** Capsule-capsule tests. */
        public var capsuleCapsuleTests:int;

        /** Capsule-box tests. */
        public var capsuleBoxTests:int;

        /** Box-box tests. */
        public var boxBoxTests:int;

        /** Pairs of agents of which at least one was tested by its hierarchy. */
        public var hierarchyTests:int;

        /** Pairs of nodes that these visited: nodes of both hierarchies, or a node of the one and the other's structure (§6.3.3). */
        public var nodeVisits:int;

        /** Triangle-triangle tests. */
        public var triangleTests:int;

        /** Pairs of agents that collide. */
        public var collisions:int;

        /** Calls of handlers. */
        public var handlerCalls:int;

        /**
         * Milliseconds to find the collisions. In a Flash player these are whole milliseconds, because its clock counts no others: one frame's 0 or 1
         * says little. CollisionRecorder has the mean of many frames.
         */
        public var findMs:Number = 0;

        /** Milliseconds of the whole frame, handlers included. In a Flash player they are whole, as for findMs. */
        public var frameMs:Number = 0;

        /** All zero. */
        public function CollisionStatistics()
        {
        }

        /** Intersection tests of all kinds of structures, without those of the nodes of hierarchies. */
        public function get tests():int
        {
            return sphereSphereTests + sphereCapsuleTests + sphereBoxTests + capsuleCapsuleTests + capsuleBoxTests + boxBoxTests;
        }

        /** Sets every number to 0. */
        public function reset():void
        {
            copyFrom(ZERO);
        }

        /** @private Copies what a search did. */
        engine function setCounts(counts:SearchCounts, milliseconds:Number):void
        {
            handlerCalls = frameMs = 0;
            agents = counts.agents;
            agentsSkipped = counts.agentsSkipped;
            agentsLoading = counts.agentsLoading;
            binEntries = counts.binEntries;
            candidatePairs = counts.candidatePairs;
            sweptPairs = counts.sweptPairs;
            sphereSphereTests = counts.testsOf(BoundingStructure.SPHERE, BoundingStructure.SPHERE);
            sphereCapsuleTests = counts.testsOf(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            sphereBoxTests = counts.testsOf(BoundingStructure.SPHERE, BoundingStructure.BOX);
            capsuleCapsuleTests = counts.testsOf(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            capsuleBoxTests = counts.testsOf(BoundingStructure.CAPSULE, BoundingStructure.BOX);
            boxBoxTests = counts.testsOf(BoundingStructure.BOX, BoundingStructure.BOX);
            hierarchyTests = counts.hierarchyTests;
            nodeVisits = counts.nodeVisits;
            triangleTests = counts.triangleTests;
            collisions = counts.collisions;
            findMs = milliseconds;
        }

        /** Copies every number of another frame. */
        public function copyFrom(other:CollisionStatistics):void
        {
            agents = other.agents;
            agentsSkipped = other.agentsSkipped;
            agentsLoading = other.agentsLoading;
            binEntries = other.binEntries;
            candidatePairs = other.candidatePairs;
            sweptPairs = other.sweptPairs;
            sphereSphereTests = other.sphereSphereTests;
            sphereCapsuleTests = other.sphereCapsuleTests;
            sphereBoxTests = other.sphereBoxTests;
            capsuleCapsuleTests = other.capsuleCapsuleTests;
            capsuleBoxTests = other.capsuleBoxTests;
            boxBoxTests = other.boxBoxTests;
            hierarchyTests = other.hierarchyTests;
            nodeVisits = other.nodeVisits;
            triangleTests = other.triangleTests;
            collisions = other.collisions;
            handlerCalls = other.handlerCalls;
            findMs = other.findMs;
            frameMs = other.frameMs;
        }
    }
}
