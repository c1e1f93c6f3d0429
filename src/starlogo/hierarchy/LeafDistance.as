package starlogo.hierarchy
{
    /**
     * Finds the distance of the contents of leaves. Abstract: a lower package defines the contents.
     *
     * @private
     */
    public class LeafDistance
    {
        /** The smallest distance of the pairs of leaves added, in the first model's space. */
        public var least:Number = Infinity;

        /** The vector from the first model's point to the second's at the smallest distance. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** For subclasses only. */
        public function LeafDistance()
        {
        }

        /** Adds a leaf of the first model and a leaf of the second. */
        public function add(a:HierarchyNode, b:HierarchyNode):void
        {
        }
    }
}
