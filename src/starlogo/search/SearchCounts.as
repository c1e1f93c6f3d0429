package starlogo.search
{
    /**
     * What a search did: see CollisionStatistics, which says the same to clients.
     *
     * @private
     */
    public final class SearchCounts
    {
        /** Agents in the list. */
        public var agents:int;

        /** Agents whose breeds are in no pair that counts. */
        public var agentsSkipped:int;

        /** Agents whose models are loading. */
        public var agentsLoading:int;

        /** Entries of agents in bins. */
        public var binEntries:int;

        /** Pairs whose circles on the ground overlap. */
        public var candidatePairs:int;

        /** Pairs that were tested along their motions. */
        public var sweptPairs:int;

        /** Pairs of which at least one agent was tested by its hierarchy. */
        public var hierarchyTests:int;

        /** Pairs of nodes that were visited. */
        public var nodeVisits:int;

        /** Pairs of triangles that were tested. */
        public var triangleTests:int;

        /** Pairs that were found. */
        public var collisions:int;

        /** Tests of two structures: at four times the kind of one structure plus that of the other. */
        public var tests:Vector.<int> = new Vector.<int>(16, true);

        /** All zero. */
        public function SearchCounts()
        {
        }

        /** Sets the numbers to 0 that are counted up; the others are set at the end of a search. */
        public function reset():void
        {
            sweptPairs = hierarchyTests = nodeVisits = triangleTests = 0;
            for (var i:int = 0; i < 16; i++)
            {
                tests[i] = 0;
            }
        }

        /** Tests of structures of two kinds, in either order. */
        public function testsOf(kind:int, otherKind:int):int
        {
            var count:int = tests[kind << 2 | otherKind];
            return kind == otherKind ? count : count + tests[otherKind << 2 | kind];
        }
    }
}
