package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.ShearedRay;
    import starlogo.intersection.ray.SpanFinder;

    use namespace engine;

    /**
     * Finds all crossings of a ray with the surface of a model: its tree, visited to a depth, or its triangles. TreeRayEntryQuery finds the first. The two are
     * apart because few games ask for all, and the others need not load it.
     *
     * @private
     */
    public final class TreeRayCrossingQuery extends NodeVisitor
    {
        private var _search:BoxSearch = new BoxSearch();
        private var _ray:Ray = null;
        private var _all:RayCrossings = null;

        // If triangles decide: the model's triangles, null otherwise; and the ray for them.
        private var _mesh:TriangleMesh = null;
        private var _shearedRay:ShearedRay = new ShearedRay();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        // If nodes decide: the part of the ray in the current one.
        private var _span:RaySpan = new RaySpan();

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
            _ray = ray;
            _all = out;
            limit = ray.to;
            _mesh = depth == BoxTree.EXACT ? model.mesh : null;
            if (_mesh != null)
            {
                _shearedRay.setTo(ray, model.boxTree.radiusAboutOrigin);
            }
            _search.visitAlong(ray, model.boxTree, depth, this);
            return _mesh != null;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (_mesh == null)
            {
                if (SpanFinder.findInBox(_ray, tree.boxOf(node), TreeRayEntryQuery.NOT_WIDENED, _span))
                {
                    _all.addSpan(_ray, _span, Tolerances.ROUNDING * tree.radiusAboutOrigin);
                }
                return;
            }
            for (var i:int = tree.first[node]; i < tree.end[node]; i++)
            {
                _mesh.readTriangle(i, _corners);
                _shearedRay.addCrossing(_corners, tree.items[i], _all);
            }
        }
    }
}
