package starlogo.collision
{
    import starlogo.search.SearchCounts;

    /**
     * What one frame of collision detection did and cost. The next frame overwrites it; copy the numbers to keep them.
     */
    public final class CollisionStatistics extends SearchCounts
    {
        private static const ZERO:CollisionStatistics = new CollisionStatistics();

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
