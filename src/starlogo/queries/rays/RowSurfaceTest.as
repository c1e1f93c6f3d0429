package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.SpanFinder;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Finds all surfaces of a row that a ray crosses, as a collider sees the row. RowRayTest finds the first, and says how. Walks load only that.
     *
     * @private
     */
    public final class RowSurfaceTest
    {
        private var _seen:SeenAgents;
        private var _rowRays:RowRayTest;

        // All crossings with a row's shape, and those that are surfaces.
        private var _crossings:RayCrossings = new RayCrossings();
        private var _surfaces:SurfaceCrossings = new SurfaceCrossings();

        /**
         * @param seen has the rows
         * @param rowRays brings rays into the space of a model
         */
        public function RowSurfaceTest(seen:SeenAgents, rowRays:RowRayTest)
        {
            _seen = seen;
            _rowRays = rowRays;
        }

        /**
         * Adds a hit for each surface of a row that a ray crosses, in the order of the ray.
         *
         * @param ray the ray in the world. A surface at exactly <code>to</code> is crossed
         */
        public function addSurfaces(row:int, ray:Ray, out:RayHits):void
        {
            var body:Body = _seen.table.bodyOf(row);
            var isGround:Boolean = body.kind == ModelShape.GROUND;
            _crossings.count = 0;
            if (isGround)
            {
                _seen.narrowPhase.groundTestsOf(body).findCrossings(body, ray, _crossings);
                _surfaces.findOfTriangles(_crossings);
            }
            else if (_rowRays.bringIntoModel(ray, body.placement) && addCrossings(body, _crossings))
            {
                _surfaces.findOfTriangles(_crossings);
            }
            else
            {
                _surfaces.findOfSolids(_crossings);
            }
            for (var i:int = 0; i < _surfaces.indices.count; i++)
            {
                var crossing:RayCrossing = _crossings.items[_surfaces.indices.values[i]];
                if (!isGround)
                {
                    _rowRays.bringIntoWorld(crossing, body.placement, ray);
                }
                if (crossing.distance <= ray.to)
                {
                    out.add(row, ray, crossing);
                }
            }
        }

        // Adds the crossings of the ray in the model's space with a body's shape. Returns whether they are those of triangles.
        private function addCrossings(body:Body, out:RayCrossings):Boolean
        {
            var shape:ModelShape = body.shape;
            var rayInModel:Ray = _rowRays.rayInModel;
            if (shape.tree != null)
            {
                return _rowRays.trees.findAll(shape.tree, _seen.narrowPhase.treeLimits.depthOf(body), rayInModel, out);
            }
            if (SpanFinder.find(rayInModel, shape.structure, _seen.narrowPhase.convexSpans, _rowRays.span))
            {
                out.addSpan(rayInModel, _rowRays.span, 0);
            }
            return false;
        }
    }
}
