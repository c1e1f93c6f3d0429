package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /** The counts of one search for collisions: agents, pairs and tests. CollisionStatistics has these counts and more. */
    public class SearchCounts
    {
        /** The number of agents in the list. */
        public var agents:int;

        /** Agents that were skipped, because their breeds have no handlers or because the Collision's filter excludes them. */
        public var agentsSkipped:int;

        /** Agents whose models are still loading. They collide with nothing. */
        public var agentsLoading:int;

        /**
         * Pairs of agents that the bins have found near each other and whose breeds have handlers for each other: all whose extents overlap, and
         * some whose circles on the ground do. Pairs of agents that have not changed may be left out: see CollisionStatistics.
         */
        public var candidatePairs:int;

        /** Pairs that were tested along their motion: an agent of the pair sweeps, and the two came near each other. */
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

        /** Tests of a hull with a sphere, a capsule, a box or a hull. */
        public var hullTests:int;

        /** Pairs of agents of which at least one was tested by its hierarchy. */
        public var hierarchyTests:int;

        /**
         * Pairs of nodes that the hierarchies' tests visited. A pair is two nodes of two hierarchies, or a node and the other agent's structure
         * (thesis §6.3.3).
         */
        public var nodeVisits:int;

        /** Tests of two triangles, or of a triangle and a structure. */
        public var triangleTests:int;

        /** Pairs of agents that collide. */
        public var collisions:int;

        /** @private Copies the counts of another search. */
        engine function copyCounts(other:SearchCounts):void
        {
            agents = other.agents;
            agentsSkipped = other.agentsSkipped;
            agentsLoading = other.agentsLoading;
            candidatePairs = other.candidatePairs;
            sweptPairs = other.sweptPairs;
            sphereSphereTests = other.sphereSphereTests;
            sphereCapsuleTests = other.sphereCapsuleTests;
            sphereBoxTests = other.sphereBoxTests;
            capsuleCapsuleTests = other.capsuleCapsuleTests;
            capsuleBoxTests = other.capsuleBoxTests;
            boxBoxTests = other.boxBoxTests;
            hullTests = other.hullTests;
            hierarchyTests = other.hierarchyTests;
            nodeVisits = other.nodeVisits;
            triangleTests = other.triangleTests;
            collisions = other.collisions;
        }

        /** @private Takes the numbers of pairs and tests of a narrow phase. */
        engine function copyTests(tests:TestCounts):void
        {
            candidatePairs = tests.candidatePairs;
            sweptPairs = tests.sweptPairs;
            var structures:Vector.<int> = tests.structures;
            sphereSphereTests = testsOf(structures, BoundingStructure.SPHERE, BoundingStructure.SPHERE);
            sphereCapsuleTests = testsOf(structures, BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            sphereBoxTests = testsOf(structures, BoundingStructure.SPHERE, BoundingStructure.BOX);
            capsuleCapsuleTests = testsOf(structures, BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            capsuleBoxTests = testsOf(structures, BoundingStructure.CAPSULE, BoundingStructure.BOX);
            boxBoxTests = testsOf(structures, BoundingStructure.BOX, BoundingStructure.BOX);
            hullTests = 0;
            for (var kind:int = 0; kind < BoundingStructure.KIND_COUNT; kind++)
            {
                hullTests += testsOf(structures, kind, BoundingStructure.HULL);
            }
            hierarchyTests = tests.trees.pairTests;
            nodeVisits = tests.trees.nodeVisits;
            triangleTests = tests.trees.triangleTests;
        }

        // The number of tests of two kinds, in either order.
        private static function testsOf(structures:Vector.<int>, a:int, b:int):int
        {
            var count:int = structures[BoundingStructure.KIND_COUNT * a + b];
            return a == b ? count : count + structures[BoundingStructure.KIND_COUNT * b + a];
        }

        /** All tests between two structures. Tests of the nodes of hierarchies are not included. */
        public function get tests():int
        {
            return sphereSphereTests + sphereCapsuleTests + sphereBoxTests + capsuleCapsuleTests + capsuleBoxTests + boxBoxTests + hullTests;
        }
    }
}
