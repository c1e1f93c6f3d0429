package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ray.crossStructure;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.rayStructure;
    import starlogo.queries.Hits;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.TreeLimits;
    import starlogo.solid.ModelRayQuery;

    use namespace engine;

    /**
     * Finds the point where a ray first meets a row, or all surfaces that it crosses, as a collider sees the row.
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
                return _seen.narrowPhase.groundTestsOf(body).isMet(body, ray);
            }
            var placement:Placement = body.placement;
            var line:Ray = _inModel;
            var ahead:Number = aheadOf(ray, placement);
            bringIntoModel(ray, placement, ahead, line);
            var start:Number = line.from;
            return line.isFinite && findHitOfShape(body, line) && bringBack(line, start, placement, ahead, ray);
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
            var line:Ray = _inModel;
            var crossings:RayCrossings = _crossings;
            var isGround:Boolean = body.form == ModelShape.GROUND;
            var areTriangles:Boolean = true;
            var isMet:Boolean = false;
            var ahead:Number = 0;
            ray.from = 0;
            crossings.count = 0;
            if (isGround)
            {
                _seen.narrowPhase.groundTestsOf(body).findCrossings(body, ray, crossings);
            }
            else
            {
                ahead = aheadOf(ray, body.placement);
                bringIntoModel(ray, body.placement, ahead, line);
                areTriangles = line.isFinite && cross(body, line, crossings);
            }
            var start:Number = line.from;
            _order.arrange(crossings, areTriangles);
            for (var i:int = 0; i < _order.left.count; i++)
            {
                takeCrossing(crossings, _order.left.numbers[i], isGround ? ray : line);
                if (isGround ? ray.from <= ray.to : bringBack(line, start, body.placement, ahead, ray))
                {
                    out.addRay(row, ray);
                    isMet = true;
                }
            }
            ray.from = 0;
            return isMet;
        }

        // Lets a ray begin at a crossing, with the normal and the triangle there.
        private static function takeCrossing(crossings:RayCrossings, crossing:int, ray:Ray):void
        {
            ray.from = crossings.places[crossing];
            ray.triangle = crossings.triangles[crossing];
            ray.setNormal(crossings.normals[3 * crossing], crossings.normals[3 * crossing + 1], crossings.normals[3 * crossing + 2]);
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

        // How far the place of a row is along a ray.
        private static function aheadOf(ray:Ray, placement:Placement):Number
        {
            return (placement.x - ray.x) * ray.directionX + (placement.y - ray.y) * ray.directionY + (placement.z - ray.z) * ray.directionZ;
        }

        // Moves a ray into the space of a row's model. The last argument receives it.
        private static function bringIntoModel(ray:Ray, placement:Placement, ahead:Number, line:Ray):void
        {
            line.directionX = ray.directionX;
            line.directionY = ray.directionY;
            line.directionZ = ray.directionZ;
            line.x = ahead * line.directionX - (placement.x - ray.x);
            line.y = ahead * line.directionY - (placement.y - ray.y);
            line.z = ahead * line.directionZ - (placement.z - ray.z);
            var size:Number = placement.size;
            line.bringInto(placement, line);
            line.from = -ahead / size;
            // because of rounding this end is a little too far; hits beyond the exact end are refused later
            line.to = (ray.to - ahead + Tolerances.ROUNDING * (ray.to + Math.abs(ahead))) / size;
            line.faceBack();
            line.triangle = -1;
        }

        // Writes where a ray in a model's space begins now, its normal and its triangle to the ray in the world. It began at the start before.
        // Returns whether that is not beyond the ray's end.
        private static function bringBack(line:Ray, start:Number, placement:Placement, ahead:Number, ray:Ray):Boolean
        {
            ray.from = 0;
            if (line.from > start)
            {
                ray.from = Math.max(0, line.from * placement.size + ahead);
            }
            ray.triangle = line.triangle;
            ray.normalX = placement.r00 * line.normalX + placement.r01 * line.normalY + placement.r02 * line.normalZ;
            ray.normalY = placement.r10 * line.normalX + placement.r11 * line.normalY + placement.r12 * line.normalZ;
            ray.normalZ = placement.r20 * line.normalX + placement.r21 * line.normalY + placement.r22 * line.normalZ;
            return ray.from <= ray.to;
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
            return rayStructure(found, shape.structure, _seen.narrowPhase.convexRay);
        }
    }
}
