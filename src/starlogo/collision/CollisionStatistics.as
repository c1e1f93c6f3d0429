package starlogo.collision
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.CollisionSearch;
    import starlogo.search.FoundPairs;
    import starlogo.search.SearchCounts;

    use namespace engine;

    /**
     * Counts and times of one frame of collision detection. The next frame overwrites them; copy numbers that you want to keep.
     *
     * <p>Candidates and tests are counted as the frame has made them. If few agents have changed since the last frame, a frame tests only the
     * pairs of these agents. So these counts depend on the frames before, also on whether there was a frame before.</p>
     */
    public final class CollisionStatistics
    {
        private static const ZERO:CollisionStatistics = new CollisionStatistics();

        /** The number of agents in the list. */
        public var agents:int;

        /** Agents that were skipped, because their breeds have no handlers or because the Collision's filter excludes them. */
        public var agentsSkipped:int;

        /** Agents whose models are still loading. They collide with nothing. */
        public var agentsLoading:int;

        /**
         * Pairs of agents that the bins have found near each other and whose breeds have handlers for each other: all whose extents overlap, and
         * some whose circles on the ground do. Pairs of agents that have not changed may be left out.
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

        /** Calls of handlers. */
        public var handlerCalls:int;

        /**
         * Milliseconds to find the collisions. A Flash player's clock counts whole milliseconds only, so the time of one frame says little.
         * CollisionRecorder has the mean of many frames.
         */
        public var findMs:Number = 0;

        /** Milliseconds of the whole frame, handlers included. In a Flash player it is a whole number, as findMs is. */
        public var frameMs:Number = 0;

        /** All tests between two structures. Tests of the nodes of hierarchies are not included. */
        public function get tests():int
        {
            return sphereSphereTests + sphereCapsuleTests + sphereBoxTests + capsuleCapsuleTests + capsuleBoxTests + boxBoxTests + hullTests;
        }

        /** The most important counts of the frame, in words. */
        public function toString():String
        {
            return agents + " agents, " + candidatePairs + " candidates, " + collisions + " collisions, " + handlerCalls + " calls of handlers, "
                + frameMs + " ms";
        }

        /** Sets every number to 0. */
        public function reset():void
        {
            copyFrom(ZERO);
        }

        /** Copies every number of another frame. */
        public function copyFrom(other:CollisionStatistics):void
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
            handlerCalls = other.handlerCalls;
            findMs = other.findMs;
            frameMs = other.frameMs;
        }

        /** @private Takes the counts of a search that has just found some pairs. */
        engine function readSearch(search:CollisionSearch, found:FoundPairs):void
        {
            var counts:SearchCounts = search.narrowPhase.counts;
            agents = search.table.listed.rows.count;
            agentsLoading = search.table.loadingCount;
            agentsSkipped = agents - agentsLoading - search.memberCount;
            collisions = found.count;
            candidatePairs = counts.candidatePairs;
            sweptPairs = counts.sweptPairs;
            var structures:Vector.<int> = counts.structures;
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
            hierarchyTests = counts.trees.pairTests;
            nodeVisits = counts.trees.nodeVisits;
            triangleTests = counts.trees.triangleTests;
        }

        // The number of tests of two kinds, in either order.
        private static function testsOf(structures:Vector.<int>, a:int, b:int):int
        {
            var count:int = structures[BoundingStructure.KIND_COUNT * a + b];
            return a == b ? count : count + structures[BoundingStructure.KIND_COUNT * b + a];
        }
    }
}
