package starlogo.search
{
    /**
     * What a search did: see CollisionStatistics, which says the same to clients.
     *
     * @private
     */
    public final class SearchCounts
    {
        // what these count stands in CollisionStatistics
        public var agents:int;
        public var agentsSkipped:int;
        public var agentsLoading:int;
        public var binEntries:int;
        public var candidatePairs:int;
        public var sweptPairs:int;
        public var hierarchyTests:int;
        public var nodeVisits:int;
        public var triangleTests:int;
        public var collisions:int;

        /** Tests of two structures: at four times the kind of the one plus that of the other. */
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
