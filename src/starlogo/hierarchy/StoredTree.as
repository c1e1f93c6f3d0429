package starlogo.hierarchy
{
    import starlogo.steps.Steps;

    /**
     * A stored record of how a hierarchy divided its items. Makes the nodes again, in steps, so that a HierarchyBuilder need not divide the
     * items again.
     *
     * @private
     */
    public interface StoredTree extends Steps
    {
        /**
         * Sets the items of the nodes. Must be called before the first step.
         *
         * @param hierarchy has room for the order of its items; receives that order and its root
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each; null if the vertices are the items
         * @param maxDepth the largest number of levels
         */
        function start(hierarchy:Hierarchy, vertices:Vector.<Number>, triangles:Vector.<uint>, maxDepth:int):void;

        /** After the last step, the nodes, parents before their children. Null if the record does not divide these items. */
        function get nodes():Vector.<HierarchyNode>;
    }
}
