package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /**
     * What a search counts while it runs, as a record: candidates and tests. CollisionStatistics shows them to games.
     *
     * @private
     */
    public final class SearchCounts
    {
        /** Candidate pairs of a search whose breeds are of interest. */
        public var candidatePairs:int = 0;

        /** Pairs of a search that were tested along their motions. */
        public var sweptPairs:int = 0;

        /** Tests of two structures, by the kinds of the first and of the second: the index is that of the first times KIND_COUNT, plus that of the second. */
        public var structures:Vector.<int> = new Vector.<int>(BoundingStructure.KIND_COUNT * BoundingStructure.KIND_COUNT, true);

        /** Tests of which at least one body is a tree. */
        public var trees:TreeCounts = new TreeCounts();

        /** Sets all to 0. */
        public function clear():void
        {
            candidatePairs = sweptPairs = 0;
            for (var i:int = 0; i < structures.length; i++)
            {
                structures[i] = 0;
            }
            trees.pairTests = trees.nodeVisits = trees.triangleTests = 0;
        }
    }
}
