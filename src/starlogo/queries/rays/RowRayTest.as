package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
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
     * Finds where a ray first meets a row, or all surfaces of the row that it crosses, as a collider sees the row.
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
    public final class RowRayTest
    {
        private var _seen:SeenAgents;

        // The ray in the space of the row's model, the part of it in a structure, and how it meets a tree.
        private var _rayInModel:Ray = new Ray();
        private var _span:RaySpan = new RaySpan();
        private var _trees:TreeRayQuery = new TreeRayQuery();

        /** @param seen has the rows */
        public function RowRayTest(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Finds where a ray first meets a row that has a shape.
         *
         * @param ray the ray in the world. A row at exactly <code>to</code> is met
         * @param out receives the distance of the hit, 0 if the origin is inside, and the normal and the triangle there
         * @return whether it meets the row
         */
        public function findRayEntry(row:int, ray:Ray, out:RayCrossing):Boolean
        {
            var body:Body = _seen.table.bodyOf(row);
            if (body.kind == ModelShape.GROUND)
            {
                return _seen.narrowPhase.groundTestsOf(body).findRayEntry(body, ray, out);
            }
            if (!bringIntoModel(ray, body.placement) || !findEntryOfShape(body, out))
            {
                return false;
            }
            bringIntoWorld(out, body.placement, ray);
            return out.distance <= ray.to;
        }

        /**
         * Finds the surfaces of a row that a ray crosses. The row has a shape. Because of rounding, a surface may be beyond the ray's end.
         *
         * @param ray the ray in the world
         */
        public function findSurfaces(row:int, ray:Ray, out:SurfaceCrossings):void
        {
            var body:Body = _seen.table.bodyOf(row);
            out.crossings.count = 0;
            if (body.kind == ModelShape.GROUND)
            {
                _seen.narrowPhase.groundTestsOf(body).findCrossings(body, ray, out.crossings);
                out.findSurfacesOfTriangles();
                return;
            }
            if (bringIntoModel(ray, body.placement) && addCrossingsOfShape(body, out.crossings))
            {
                out.findSurfacesOfTriangles();
            }
            else
            {
                out.findSurfacesOfParts();
            }
            for (var i:int = 0; i < out.count; i++)
            {
                bringIntoWorld(out.surfaceAt(i), body.placement, ray);
            }
        }

        // How far the place of a row is along a ray.
        private static function aheadOf(ray:Ray, placement:Placement):Number
        {
            return (placement.x - ray.origin.x) * ray.direction.x + (placement.y - ray.origin.y) * ray.direction.y + (placement.z - ray.origin.z) * ray.direction.z;
        }

        // Moves a ray into the space of a row's model. Returns whether the products of its numbers are finite there. They are not if the row is tiny and
        // far from the ray.
        private function bringIntoModel(ray:Ray, placement:Placement):Boolean
        {
            var ahead:Number = aheadOf(ray, placement);
            _rayInModel.direction.copyFrom(ray.direction);
            _rayInModel.origin.x = ahead * _rayInModel.direction.x - (placement.x - ray.origin.x);
            _rayInModel.origin.y = ahead * _rayInModel.direction.y - (placement.y - ray.origin.y);
            _rayInModel.origin.z = ahead * _rayInModel.direction.z - (placement.z - ray.origin.z);
            var size:Number = placement.size;
            _rayInModel.scaleAndRotateBack(placement);
            _rayInModel.from = -ahead / size;
            // because of rounding this end is a little too far; hits beyond the exact end are refused later
            _rayInModel.to = (ray.to - ahead + Tolerances.ROUNDING * (ray.to + Math.abs(ahead))) / size;
            return _rayInModel.isFinite;
        }

        // Moves where a ray enters a shape from the model's space into the world. Because of rounding, it may be beyond the ray's end there.
        private function bringIntoWorld(entry:RayCrossing, placement:Placement, ray:Ray):void
        {
            placement.rotate(entry.normal, entry.normal);
            entry.distance = entry.distance > _rayInModel.from ? Math.max(0, entry.distance * placement.size + aheadOf(ray, placement)) : 0;
        }

        private function findEntryOfShape(body:Body, out:RayCrossing):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.tree != null)
            {
                return _trees.find(shape.tree, _seen.narrowPhase.treeLimits.depthOf(body), _rayInModel, out);
            }
            return SpanFinder.find(_rayInModel, shape.structure, _seen.narrowPhase.convexSpans, _span) && out.setToEntry(_rayInModel, _span);
        }

        // Adds the crossings of the ray in the model's space with a body's shape. Returns whether they are those of triangles.
        private function addCrossingsOfShape(body:Body, out:RayCrossings):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.tree != null)
            {
                return _trees.findAll(shape.tree, _seen.narrowPhase.treeLimits.depthOf(body), _rayInModel, out);
            }
            if (SpanFinder.find(_rayInModel, shape.structure, _seen.narrowPhase.convexSpans, _span))
            {
                out.addSpan(_rayInModel, _span, 0);
            }
            return false;
        }
    }
}
