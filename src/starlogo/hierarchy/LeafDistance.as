package starlogo.hierarchy
{
    /**
     * Finds how far the contents of leaves are apart. Abstract: a room below this one knows what they are.
     *
     * @private
     */
    public class LeafDistance
    {
        /** The least distance of the pairs of leaves that were added, in the space of the first model. */
        public var least:Number = Infinity;

        /** From the first model's point to the second's of the least distance. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** For subclasses only. */
        public function LeafDistance()
        {
        }

        /** Adds a leaf of the first model and one of the second. */
        public function add(a:HierarchyNode, b:HierarchyNode):void
        {
        }
    }
}
