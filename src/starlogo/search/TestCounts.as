package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /**
     * The numbers of tests that a narrow phase has made since the last <code>clear()</code>, as a record.
     *
     * @private
     */
    public final class TestCounts
    {
        /** Tests of two structures, by the kinds of the first and of the second: the index is that of the first times KIND_COUNT, plus that of the second. */
        public var structures:Vector.<int> = new Vector.<int>(BoundingStructure.KIND_COUNT * BoundingStructure.KIND_COUNT, true);

        /** Tests of which at least one body is a tree. */
        public var trees:TreeCounts = new TreeCounts();

        /** Sets all to 0. */
        public function clear():void
        {
            for (var i:int = 0; i < structures.length; i++)
            {
                structures[i] = 0;
            }
            trees.pairTests = trees.nodeVisits = trees.triangleTests = 0;
        }
    }
}
