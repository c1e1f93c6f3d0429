package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.SpanFinder;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.solid.TreeRayQuery;

    use namespace engine;

    /**
     * Finds all surfaces of a row that a ray crosses, as a collider sees the row. RowRayTest finds the first, and says how. Walks load only that.
     *
     * @private
     */
    public final class RowSurfaceTest
    {
        private var _seen:SeenAgents;
        private var _rayInModel:Ray = new Ray();
        private var _span:RaySpan = new RaySpan();
        private var _treeCrossings:TreeRayQuery = new TreeRayQuery();

        // All crossings with a row's shape, and those that are surfaces.
        private var _crossings:RayCrossings = new RayCrossings();
        private var _surfaces:SurfaceCrossings = new SurfaceCrossings();

        /** @param seen has the rows */
        public function RowSurfaceTest(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds all surfaces of a row that a ray crosses.
         *
         * @param ray the ray in the world. A surface at exactly <code>to</code> is crossed
         * @param out receives a hit for each surface, in the order of the ray
         * @return whether it crosses any
         */
        public function findSurfaces(row:int, ray:Ray, out:RayHits):Boolean
        {
            var body:Body = _seen.table.bodyOf(row);
            var isGround:Boolean = body.kind == ModelShape.GROUND;
            var isMet:Boolean = false;
            _crossings.count = 0;
            if (isGround)
            {
                _seen.narrowPhase.groundTestsOf(body).findCrossings(body, ray, _crossings);
                _surfaces.findOfTriangles(_crossings);
            }
            else if (RowRayTest.bringIntoModel(ray, body.placement, _rayInModel) && addCrossings(body, _rayInModel, _crossings))
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
                    RowRayTest.bringIntoWorld(crossing, _rayInModel, body.placement, ray);
                }
                if (crossing.distance <= ray.to)
                {
                    out.add(row, ray, crossing);
                    isMet = true;
                }
            }
            return isMet;
        }

        // Adds the crossings of a ray in the model's space with a body's shape. Returns whether they are those of triangles.
        private function addCrossings(body:Body, rayInModel:Ray, out:RayCrossings):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.tree != null)
            {
                return _treeCrossings.findAll(shape.tree, _seen.narrowPhase.treeLimits.depthOf(body), rayInModel, out);
            }
            if (SpanFinder.find(rayInModel, shape.structure, _seen.narrowPhase.convexSpans, _span))
            {
                out.addSpan(rayInModel, _span, 0);
            }
            return false;
        }
    }
}
