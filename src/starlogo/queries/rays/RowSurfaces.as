package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.crossStructure;
    import starlogo.queries.Hits;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.solid.ModelRayQuery;

    use namespace engine;

    /**
     * Finds all surfaces of a row that a ray crosses, as a collider sees the row. RowRays says how it computes.
     *
     * @private
     */
    public final class RowSurfaces
    {
        private var _seen:SeenAgents;
        private var _inModel:Ray = new Ray();
        private var _solid:ModelRayQuery = new ModelRayQuery();

        // The crossings with a row's shape, their order, and a scratch ray.
        private var _crossings:RayCrossings = new RayCrossings();
        private var _order:CrossingOrder = new CrossingOrder();
        private var _part:Ray = new Ray();

        /** @param seen has the rows */
        public function RowSurfaces(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds all surfaces of a row that a ray crosses.
         *
         * @param ray the ray in the world. A surface at exactly <code>to</code> is crossed. Its beginning and its normal are overwritten
         * @param out receives a hit for each surface, in the order of the ray
         * @return whether it crosses any
         */
        public function find(row:int, ray:Ray, out:Hits):Boolean
        {
            var body:Body = _seen.table.bodyOf(row);
            var placement:Placement = body.placement;
            var crossings:RayCrossings = _crossings;
            var isMet:Boolean = false;
            var isGround:Boolean = body.form == ModelShape.GROUND;
            var start:Number = ray.from = 0;
            var areTriangles:Boolean = true;
            var line:Ray = _inModel;
            var ahead:Number = 0;
            crossings.count = 0;
            if (isGround)
            {
                _seen.narrowPhase.groundTestsOf(body).findCrossings(body, ray, crossings);
            }
            else
            {
                ahead = RowRays.aheadOf(ray, placement);
                RowRays.bringIntoModel(ray, placement, ahead, line);
                start = line.from;
                areTriangles = line.isFinite && cross(body, line, crossings);
            }
            _order.arrange(crossings, areTriangles);
            for (var i:int = 0; i < _order.left.count; i++)
            {
                var crossing:int = _order.left.numbers[i];
                var place:Number = crossings.places[crossing];
                ray.triangle = crossings.triangles[crossing];
                line.normalX = crossings.normals[3 * crossing];
                line.normalY = crossings.normals[3 * crossing + 1];
                line.normalZ = crossings.normals[3 * crossing + 2];
                if (isGround)
                {
                    ray.setNormal(line.normalX, line.normalY, line.normalZ);
                    ray.from = place;
                }
                else
                {
                    ray.from = place > start ? Math.max(0, place * placement.size + ahead) : 0;
                    RowRays.turnNormal(line, placement, ray);
                }
                if (ray.from <= ray.to)
                {
                    out.addRay(row, ray);
                    isMet = true;
                }
            }
            ray.from = 0;
            return isMet;
        }

        // Adds the crossings of a ray in the model's space with a body's shape. Returns whether they are those of triangles.
        private function cross(body:Body, line:Ray, out:RayCrossings):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.hierarchy != null)
            {
                return _solid.findAll(shape.hierarchy, _seen.narrowPhase.treeLimits.depthOf(body), _seen.narrowPhase.treeLimits.exact, line, out);
            }
            crossStructure(line, shape.structure, 0, _part, _seen.narrowPhase.convexRay, out);
            return false;
        }
    }
}
