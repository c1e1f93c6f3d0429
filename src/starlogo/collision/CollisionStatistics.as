package starlogo.collision
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.SearchCounts;

    use namespace engine;

    /**
     * What one frame of collision detection did and cost. Whoever fills it overwrites it with the next frame; copy the
     * numbers to keep them.
     */
    public final class CollisionStatistics
    {
        /** Agents in the list. */
        public var agents:int;

        /** Agents that take part in no pair that anybody cares about, and were skipped. */
        public var agentsSkipped:int;

        /** Agents whose models are still loading: they collide with nothing yet. */
        public var agentsLoading:int;

        /** Entries of agents in the thesis's bins: an agent that reaches into four of them counts four times. */
        public var binEntries:int;

        /** Pairs of agents whose circles on the ground overlap. */
        public var candidatePairs:int;

        /** Pairs of which one agent sweeps, and that came near each other on their ways: each was tested along them. */
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

        /** Pairs of agents of which one was tested by its hierarchy at least. */
        public var hierarchyTests:int;

        /** Pairs of nodes that these visited: a node of each hierarchy, or of the one, with the other's structure (§6.3.3). */
        public var nodeVisits:int;

        /** Triangle-triangle tests. */
        public var triangleTests:int;

        /** Pairs of agents that collide. */
        public var collisions:int;

        /** Calls of handlers. */
        public var handlerCalls:int;

        /** Milliseconds to find the collisions. */
        public var findMs:int;

        /** Milliseconds of the whole frame, handlers included. */
        public var frameMs:int;

        /** All zero. */
        public function CollisionStatistics()
        {
        }

        /** Intersection tests of all kinds of structures, those of the nodes of hierarchies not among them. */
        public function get tests():int
        {
            return sphereSphereTests + sphereCapsuleTests + sphereBoxTests + capsuleCapsuleTests + capsuleBoxTests + boxBoxTests;
        }

        /** Sets every number to 0. */
        public function reset():void
        {
            agents = agentsSkipped = agentsLoading = binEntries = candidatePairs = sweptPairs = 0;
            sphereSphereTests = sphereCapsuleTests = sphereBoxTests = 0;
            capsuleCapsuleTests = capsuleBoxTests = boxBoxTests = 0;
            hierarchyTests = nodeVisits = triangleTests = 0;
            collisions = handlerCalls = findMs = frameMs = 0;
        }

        /**
         * Takes over what a search did.
         *
         * @private
         */
        engine function takeCounts(counts:SearchCounts, milliseconds:int):void
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

        /** Takes over every number of another frame. */
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
