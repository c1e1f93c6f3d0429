package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeRayCrossingVisitor;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;

    use namespace engine;

    /**
     * Finds all crossings of a ray with the surface of a model: its tree, visited to a depth, or its triangles. TreeRayEntryQuery finds the first. The two are
     * apart because few games ask for all, and the others need not load it.
     *
     * @private
     */
    public final class TreeRayCrossingQuery
    {
        private var _nodes:NodeRayCrossingVisitor = new NodeRayCrossingVisitor();
        private var _triangles:TriangleRayCrossingVisitor = new TriangleRayCrossingVisitor();

        /**
         * Adds all crossings. The parameters are those of <code>TreeRayEntryQuery.find()</code>.
         *
         * @param out the crossings are added to it
         * @return whether they are those of triangles, otherwise those of nodes
         */
        public function findAll(model:ModelTree, depth:int, ray:Ray, out:RayCrossings):Boolean
        {
            if (TreeRayEntryQuery.beginsInside(model, ray))
            {
                out.addInside(ray);
            }
            if (depth == BoxTree.EXACT)
            {
                _triangles.addCrossings(model, ray, out);
                return true;
            }
            _nodes.addCrossings(model.boxTree, depth, ray, out);
            return false;
        }
    }
}
