package starlogo.hierarchy
{
    import starlogo.steps.Steps;

    /**
     * How a hierarchy divided its items, written down earlier: makes its nodes again, in steps, so that a HierarchyBuilder need not divide
     * the items once more.
     *
     * @private
     */
    public interface StoredTree extends Steps
    {
        /**
         * Says what the nodes are of: to be called before the first step.
         *
         * @param hierarchy has room for the order of its items; gets that order and its root
         * @param vertices x, y, z each
         * @param triangles three vertex indices each; null if the vertices are the items
         * @param maxDepth how many levels there may be
         */
        function start(hierarchy:Hierarchy, vertices:Vector.<Number>, triangles:Vector.<uint>, maxDepth:int):void;

        /** The nodes, parents before their children, when no step is left; null if what was written down does not divide these items. */
        function get nodes():Vector.<HierarchyNode>;

        /** What made the nodes. */
        function get maker():NodeMaker;
    }
}
