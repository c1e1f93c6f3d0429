package starlogo.queries.rays
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.SpanFinder;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.solid.TreeRayQuery;

    use namespace engine;

    /**
     * Finds where a ray first meets a row, as a collider sees the row.
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
        /** The ray of the last test in the space of the row's model. */
        internal var rayInModel:Ray = new Ray();

        /** The part of that ray in a structure. */
        internal var span:RaySpan = new RaySpan();

        /** How that ray meets trees. */
        internal var trees:TreeRayQuery = new TreeRayQuery();

        private var _seen:SeenAgents;

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

        // How far the place of a row is along a ray.
        private static function aheadOf(ray:Ray, placement:Placement):Number
        {
            return (placement.x - ray.origin.x) * ray.direction.x + (placement.y - ray.origin.y) * ray.direction.y + (placement.z - ray.origin.z) * ray.direction.z;
        }

        /**
         * Moves a ray into the space of a row's model.
         *
         * @return whether the products of its numbers are finite there. They are not if the row is tiny and far from the ray
         */
        internal function bringIntoModel(ray:Ray, placement:Placement):Boolean
        {
            var ahead:Number = aheadOf(ray, placement);
            rayInModel.direction.copyFrom(ray.direction);
            rayInModel.origin.x = ahead * rayInModel.direction.x - (placement.x - ray.origin.x);
            rayInModel.origin.y = ahead * rayInModel.direction.y - (placement.y - ray.origin.y);
            rayInModel.origin.z = ahead * rayInModel.direction.z - (placement.z - ray.origin.z);
            var size:Number = placement.size;
            rayInModel.scaleAndRotateBack(placement);
            rayInModel.from = -ahead / size;
            // because of rounding this end is a little too far; hits beyond the exact end are refused later
            rayInModel.to = (ray.to - ahead + Tolerances.ROUNDING * (ray.to + Math.abs(ahead))) / size;
            return rayInModel.isFinite;
        }

        /** Moves where a ray enters a shape from the model's space into the world. Because of rounding, it may be beyond the ray's end there. */
        internal function bringIntoWorld(entry:RayCrossing, placement:Placement, ray:Ray):void
        {
            placement.rotate(entry.normal, entry.normal);
            entry.distance = entry.distance > rayInModel.from ? Math.max(0, entry.distance * placement.size + aheadOf(ray, placement)) : 0;
        }

        private function findEntryOfShape(body:Body, out:RayCrossing):Boolean
        {
            var shape:ModelShape = body.shape;
            if (shape.tree != null)
            {
                return trees.find(shape.tree, _seen.narrowPhase.treeLimits.depthOf(body), rayInModel, out);
            }
            return SpanFinder.find(rayInModel, shape.structure, _seen.narrowPhase.convexSpans, span) && out.setToEntry(rayInModel, span);
        }
    }
}
