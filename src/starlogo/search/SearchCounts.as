package starlogo.search
{
    /** What a search for collisions did. CollisionStatistics has these counts, and more. */
    public class SearchCounts
    {
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

        /** All zero. */
        public function SearchCounts()
        {
        }

        /** Intersection tests of all kinds of structures, without those of the nodes of hierarchies. */
        public function get tests():int
        {
            return sphereSphereTests + sphereCapsuleTests + sphereBoxTests + capsuleCapsuleTests + capsuleBoxTests + boxBoxTests;
        }
    }
}
