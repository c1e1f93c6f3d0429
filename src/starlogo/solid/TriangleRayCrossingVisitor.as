package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.ShearedRay;

    use namespace engine;

    /** Finds all triangles of a model that a ray meets. */
    internal final class TriangleRayCrossingVisitor extends NodeVisitor
    {
        private var _search:BoxSearch = new BoxSearch();
        private var _mesh:TriangleMesh;
        private var _ray:ShearedRay = new ShearedRay();
        private var _all:RayCrossings;
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        /**
         * Adds all crossings of a ray with triangles.
         *
         * @param model the model; has triangles
         * @param ray in the model's space
         * @param out the crossings are added to it
         */
        public function addCrossings(model:ModelTree, ray:Ray, out:RayCrossings):void
        {
            _mesh = model.mesh;
            _ray.setTo(ray, model.boxTree.radiusAboutOrigin);
            _all = out;
            limit = ray.to;
            _search.visitAlong(ray, model.boxTree, BoxTree.EXACT, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            for (var i:int = tree.first[node]; i < tree.end[node]; i++)
            {
                _mesh.readTriangle(i, _corners);
                _ray.addCrossing(_corners, tree.items[i], _all);
            }
        }
    }
}
