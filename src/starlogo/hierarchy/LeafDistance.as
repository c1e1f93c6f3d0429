package starlogo.hierarchy
{
    import starlogo.intersection.distance.ClosestPair;

    /**
     * Finds the distance of the contents of leaves. Abstract: a lower package defines the contents.
     *
     * @private
     */
    public class LeafDistance
    {
        /** The closest points of the pairs of leaves added, and their distance, in the first model's space. */
        public var points:ClosestPair;

        /** Adds a leaf of the first model and a leaf of the second. */
        public function add(a:HierarchyNode, b:HierarchyNode):void
        {
        }
    }
}
