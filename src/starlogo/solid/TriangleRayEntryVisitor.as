package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.intersection.ray.ShearedRay;
    import starlogo.intersection.ray.TriangleCrossing;

    use namespace engine;

    /** Finds the first triangle of a model that a ray meets. */
    internal final class TriangleRayEntryVisitor extends NodeVisitor
    {
        private var _search:BoxSearch = new BoxSearch();
        private var _mesh:TriangleMesh;
        private var _ray:ShearedRay = new ShearedRay();
        private var _first:TriangleCrossing = new TriangleCrossing();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        /**
         * Finds where a ray first meets a triangle.
         *
         * @param model the model; has triangles
         * @param ray in the model's space
         * @param out receives the distance, the normal and the triangle
         * @return whether it meets one
         */
        public function findRayEntry(model:ModelTree, ray:Ray, out:RayEntry):Boolean
        {
            _mesh = model.mesh;
            _ray.setTo(ray, model.boxTree.radiusAboutOrigin);
            _first.slot = -1;
            limit = ray.to;
            _search.visitAlong(ray, model.boxTree, BoxTree.EXACT, this);
            if (_first.slot < 0)
            {
                return false;
            }
            _mesh.readTriangle(_first.slot, _corners);
            _ray.writeEntry(_corners, _first, model.boxTree.items[_first.slot], out);
            return true;
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            var corners:Vector.<int> = _mesh.corners;
            var end:int = tree.end[node];
            for (var i:int = tree.first[node]; i < end; i++)
            {
                if (_ray.findEarlier(_mesh.vertices, corners[int(3 * i)], corners[int(3 * i + 1)], corners[int(3 * i + 2)], i, _first))
                {
                    limit = _first.distance;
                }
            }
        }
    }
}
