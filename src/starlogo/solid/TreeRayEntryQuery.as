package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.ShearedRay;
    import starlogo.intersection.ray.SpanFinder;

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
    public final class TreeRayEntryQuery extends NodeVisitor
    {
        /** The factor on a node's half-extents. Nodes are enlarged as it is. A node that is only touched would be entered before a larger node around it. */
        internal static const NOT_WIDENED:Number = 1;

        private static var sStart:Vector3D = new Vector3D();

        private var _search:BoxSearch = new BoxSearch();
        private var _ray:Ray = null;

        // The slot of the triangle, or the node, that the ray meets first so far, or -1.
        private var _first:int = -1;

        // If triangles decide: the model's triangles, null otherwise; the ray for them.
        private var _mesh:TriangleMesh = null;
        private var _shearedRay:ShearedRay = new ShearedRay();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        // If nodes decide: where the ray enters the current one.
        private var _entry:RayEntry = new RayEntry();
        private var _span:RaySpan = new RaySpan();

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
            return beginsInside(model, ray) || findOnSurface(model, depth, ray, out);
        }

        /** Whether a ray begins inside of the surface of a model. */
        internal static function beginsInside(model:ModelTree, ray:Ray):Boolean
        {
            sStart.setTo(ray.x + ray.from * ray.directionX, ray.y + ray.from * ray.directionY, ray.z + ray.from * ray.directionZ);
            return model.isInside(sStart, 0);
        }

        /** Does what <code>find()</code> does if the ray begins outside. */
        internal function findOnSurface(model:ModelTree, depth:int, ray:Ray, out:RayEntry):Boolean
        {
            var tree:BoxTree = model.boxTree;
            _ray = ray;
            _first = -1;
            limit = ray.to;
            _mesh = depth == BoxTree.EXACT ? model.mesh : null;
            if (_mesh != null)
            {
                _shearedRay.setTo(ray, tree.radiusAboutOrigin);
            }
            _search.visitAlong(ray, tree, depth, this);
            if (_first >= 0 && _mesh != null)
            {
                _mesh.readTriangle(_first, _corners);
                _shearedRay.writeEntry(_corners, _shearedRay.first, tree.items[_first], out);
                return true;
            }
            return _first >= 0 && enters(tree, _first, out);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            if (_mesh != null)
            {
                visitTriangles(tree.firstSlot[node], tree.endSlot[node]);
            }
            else if (enters(tree, node, _entry) && (_entry.distance < limit || _first < 0))
            {
                _first = node;
                limit = _entry.distance;
                if (!(limit > _ray.from))
                {
                    // no node can be met before the ray's beginning
                    endSearch();
                }
            }
        }

        // Visits the triangles in some slots.
        private function visitTriangles(first:int, end:int):void
        {
            var corners:Vector.<int> = _mesh.cornerOffsets;
            for (var i:int = first; i < end; i++)
            {
                if (_shearedRay.findEarlier(_mesh.vertices, corners[int(3 * i)], corners[int(3 * i + 1)], corners[int(3 * i + 2)]))
                {
                    _first = i;
                    limit = _shearedRay.first.distance;
                }
            }
        }

        // Finds where the ray enters the box of a node. Returns whether it does.
        private function enters(tree:BoxTree, node:int, out:RayEntry):Boolean
        {
            return SpanFinder.findInBox(_ray, tree.boxOf(node), NOT_WIDENED, _span) && out.enter(_ray, _span);
        }
    }
}
