package starlogo.queries
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ray.ConvexRay;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.crossStructure;
    import starlogo.intersection.ray.rayStructure;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.TreeLimits;
    import starlogo.solid.ModelRayQuery;

    use namespace engine;

    /**
     * Finds the point where a ray first meets a row, as a collider sees the row, or all surfaces of the row that it crosses.
     *
     * <p>It first moves the ray into the space of the row's model. There the structure, the tree and the triangles are as they were fitted,
     * and rounding errors depend on the model's size, not on its place. The ray is given there by the point of its line that is nearest to
     * the row's place. This is the same for all systems. So if a ray meets a model's triangles, it meets the structures around them at the
     * same distance or earlier.</p>
     *
     * <p>A ray is a line without thickness. So the margin by which shapes are widened for touching (Tolerances.PLACES) is not added.</p>
     *
     * @private
     */
    public final class RowRays
    {
        private var _seen:SeenAgents;
        private var _inModel:Ray = new Ray();
        private var _solid:ModelRayQuery = new ModelRayQuery();

        // How far the row's place is along the ray.
        private var _ahead:Number = 0;

        // The crossings with a row's shape, their order, and a scratch ray.
        private var _crossings:RayCrossings = new RayCrossings();
        private var _order:CrossingOrder = new CrossingOrder();
        private var _part:Ray = new Ray();

        /** @param seen has the rows */
        public function RowRays(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds where a ray first meets a row that has a shape.
         *
         * @param ray the ray in the world. A row at exactly <code>to</code> is met. After a hit, <code>from</code> is the hit's distance, 0 if the
         *     origin is inside, and the ray has the normal and the triangle there
         * @return whether it meets the row
         */
        public function findHit(row:int, ray:Ray):Boolean
        {
            var body:Body = _seen.table.bodyOf(row);
            ray.from = 0;
            ray.triangle = -1;
            if (body.form == ModelShape.GROUND)
            {
                return _seen.narrowPhase.testsOfWorldAgent(body).isMet(body, ray);
            }
            var placement:Placement = body.placement;
            var line:Ray = _inModel;
            bringIntoModel(ray, placement, line);
            var start:Number = line.from;
            if (!line.isFinite || !findHitOfShape(body, line))
            {
                return false;
            }
            if (line.from > start)
            {
                ray.from = Math.max(0, line.from * placement.size + _ahead);
            }
            if (ray.from > ray.to)
            {
                return false;
            }
            ray.triangle = line.triangle;
            turnNormal(line, placement, ray);
            return true;
        }

        /**
         * Finds all surfaces of a row that a ray crosses.
         *
         * @param ray the ray in the world. A surface at exactly <code>to</code> is crossed. Its beginning and its normal are overwritten
         * @param out receives a hit for each surface, in the order of the ray
         * @return whether it crosses any
         */
        public function findSurfaces(row:int, ray:Ray, out:Hits):Boolean
        {
            var body:Body = _seen.table.bodyOf(row);
            var placement:Placement = body.placement;
            var crossings:RayCrossings = _crossings;
            var isMet:Boolean = false;
            var isOfTheWorld:Boolean = body.form == ModelShape.GROUND;
            var start:Number = ray.from = 0;
            var areTriangles:Boolean = true;
            var line:Ray = _inModel;
            crossings.count = 0;
            if (isOfTheWorld)
            {
                _seen.narrowPhase.testsOfWorldAgent(body).findCrossings(body, ray, crossings);
            }
            else
            {
                bringIntoModel(ray, placement, line);
                start = line.from;
                areTriangles = line.isFinite && cross(body, line, crossings);
            }
            _order.arrange(crossings, areTriangles);
            for (var i:int = 0; i < _order.count; i++)
            {
                var crossing:int = _order.indices[i];
                var place:Number = crossings.places[crossing];
                ray.triangle = crossings.triangles[crossing];
                line.normalX = crossings.normals[3 * crossing];
                line.normalY = crossings.normals[3 * crossing + 1];
                line.normalZ = crossings.normals[3 * crossing + 2];
                if (isOfTheWorld)
                {
                    ray.setNormal(line.normalX, line.normalY, line.normalZ);
                    ray.from = place;
                }
                else
                {
                    ray.from = place > start ? Math.max(0, place * placement.size + _ahead) : 0;
                    turnNormal(line, placement, ray);
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
            crossStructure(line, shape.structure, 0, _part, convexRay, out);
            return false;
        }

        private function get convexRay():ConvexRay
        {
            return _seen.narrowPhase.structures == null ? null : _seen.narrowPhase.structures.convexRay;
        }

        private function bringIntoModel(ray:Ray, placement:Placement, line:Ray):void
        {
            var toX:Number = placement.x - ray.x;
            var toY:Number = placement.y - ray.y;
            var toZ:Number = placement.z - ray.z;
            line.directionX = ray.directionX;
            line.directionY = ray.directionY;
            line.directionZ = ray.directionZ;
            var ahead:Number = _ahead = toX * line.directionX + toY * line.directionY + toZ * line.directionZ;
            line.x = ahead * line.directionX - toX;
            line.y = ahead * line.directionY - toY;
            line.z = ahead * line.directionZ - toZ;
            var size:Number = placement.size;
            line.bringInto(placement, line);
            line.from = -ahead / size;
            // because of rounding this end is a little too far; hits beyond the exact end are refused later
            line.to = (ray.to - ahead + Tolerances.ROUNDING * (ray.to + Math.abs(ahead))) / size;
            line.faceBack();
            line.triangle = -1;
        }

        private static function turnNormal(line:Ray, placement:Placement, ray:Ray):void
        {
            ray.normalX = placement.r00 * line.normalX + placement.r01 * line.normalY + placement.r02 * line.normalZ;
            ray.normalY = placement.r10 * line.normalX + placement.r11 * line.normalY + placement.r12 * line.normalZ;
            ray.normalZ = placement.r20 * line.normalX + placement.r21 * line.normalY + placement.r22 * line.normalZ;
        }

        private function findHitOfShape(body:Body, found:Ray):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.hierarchy != null)
            {
                var limits:TreeLimits = _seen.narrowPhase.treeLimits;
                var isMet:Boolean = _solid.find(shape.hierarchy, limits.depthOf(body), limits.exact, found);
                found.triangle = _solid.triangle;
                return isMet;
            }
            return rayStructure(found, shape.structure, convexRay);
        }
    }
}
