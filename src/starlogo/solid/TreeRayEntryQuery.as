package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeRayEntryVisitor;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;

    use namespace engine;

    /**
     * Finds where a ray first meets a model: its tree, visited to a depth, or its triangles. A ray that begins inside of a closed surface meets the
     * model at once.
     *
     * <p>The answers are nested: no depth finds a hit farther away than a greater depth or the triangles do. The inside is tested at every
     * depth, because the nodes cover only the surface. Nothing is allocated once the stacks have grown and the model's triangles are
     * prepared.</p>
     *
     * @private
     */
    public final class TreeRayEntryQuery
    {
        private static const START:Vector3D = new Vector3D();

        private var _nodes:NodeRayEntryVisitor = new NodeRayEntryVisitor();
        private var _triangles:TriangleRayEntryVisitor = new TriangleRayEntryVisitor();

        /**
         * Finds where a ray first meets a model.
         *
         * @param model the model
         * @param depth how many of its levels are visited; BoxTree.EXACT if its triangles decide
         * @param ray in the model's space
         * @param out receives the distance, the normal and the triangle
         * @return whether there is a hit
         */
        public function find(model:ModelTree, depth:int, ray:Ray, out:RayEntry):Boolean
        {
            out.setToStart(ray);
            if (beginsInside(model, ray))
            {
                return true;
            }
            if (depth == BoxTree.EXACT)
            {
                return _triangles.findRayEntry(model, ray, out);
            }
            return _nodes.findRayEntry(model.boxTree, depth, ray, out);
        }

        /** Whether a ray begins inside of the surface of a model. */
        internal static function beginsInside(model:ModelTree, ray:Ray):Boolean
        {
            START.setTo(ray.x + ray.from * ray.directionX, ray.y + ray.from * ray.directionY, ray.z + ray.from * ray.directionZ);
            return model.isInside(START, 0);
        }
    }
}
