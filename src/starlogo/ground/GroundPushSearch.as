package starlogo.ground
{
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.HalfSpaceSolver;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the push that leads a model out of the ground, by planes alone. It begins with the exit of the deepest point. If the model is still in the ground
     * where the push leads, the next push is out of another plane too: out of a valley along both of its sides.
     */
    internal final class GroundPushSearch
    {
        // Models that are larger than this many cells have other tests, which need not look at all cells.
        private static const MAX_CELLS:Number = 8;

        // A push must be longer than this many times the probe.
        private static const MIN_PROBES:Number = 8;

        // The probe must be longer than this many times the gap across which surfaces touch.
        private static const MIN_MARGINS:Number = 8;

        /** Whether planes show that the push that is found leads out. If not, only a test of the model's pieces shows it. Read only. */
        public var isFree:Boolean = false;

        private var _deepest:DeepestPointSearch = new DeepestPointSearch();
        private var _planes:GroundPlanes = new GroundPlanes();
        private var _separation:GroundSeparation = new GroundSeparation(_planes);
        private var _exits:GroundExits = new GroundExits();

        /**
         * Finds the push.
         *
         * @param model where it stands
         * @param search has the ground and the origin
         * @param probe the model is in the ground so far before the end of the push, and is free so far behind it
         * @param out receives the push as a contact, in the world. If no deepest point of the model is known, only a test shows whether the model is in the
         *     ground before the end
         * @return whether there is a push
         */
        public function find(model:ModelPiece, search:GroundSearch, probe:Number, out:ContactPoint):Boolean
        {
            var separation:int = GroundSeparation.BLOCKED;
            model.findWholeBox();
            _planes.clear();
            if (!isSmall(model.box, search.grid) || probe < MIN_MARGINS * marginOf(model, search.grid) || !_deepest.beginUnder(model, search, _planes.next))
            {
                return false;
            }
            while (separation == GroundSeparation.BLOCKED)
            {
                if (!_planes.hasRoom || !addExit(model, search) || !_planes.solve() || _planes.push.distance <= MIN_PROBES * probe)
                {
                    return false;
                }
                _planes.displace(probe);
                separation = _separation.find(model, search, probe / 4);
            }
            isFree = separation == GroundSeparation.SEPARATED;
            return findContact(search, probe, out);
        }

        private static function isSmall(box:GroundBox, grid:HeightGrid):Boolean
        {
            return 2 * Math.max(box.halfX, box.halfY) <= MAX_CELLS * grid.cellWidth;
        }

        // The gap across which the model and the surface touch, with all that is rounded.
        private static function marginOf(model:ModelPiece, grid:HeightGrid):Number
        {
            var heights:HeightBounds = grid.pyramid.whole;
            var box:GroundBox = model.box;
            return model.modelMargin + Tolerances.ROUNDING * (grid.cellWidth + heights.max - heights.min + box.halfX + box.halfY + box.halfZ);
        }

        // Adds the exit of the point that is deepest if one follows the normals from the next plane on. Returns whether the last push does not lead out of it.
        private function addExit(model:ModelPiece, search:GroundSearch):Boolean
        {
            var first:int = _planes.count;
            _deepest.addExit(model, search, _planes);
            return _planes.areInWay(first);
        }

        // Finds the contact of the push. Its deepest point is one that is still under the ground there, and whose depth is proven. Returns whether there is one.
        private function findContact(search:GroundSearch, probe:Number, out:ContactPoint):Boolean
        {
            var push:HalfSpaceSolver = _planes.push;
            var depth:Number = push.distance;
            out.setNormal(push.displacement.x / depth, push.displacement.y / depth, push.displacement.z / depth);
            out.depth = depth;
            out.forget();
            // a little before the end
            _planes.displace(-probe);
            for (var i:int = 0; i < _planes.count; i++)
            {
                var plane:GroundPlane = _planes.planes[i];
                if (plane.depthUnderGround(search, _planes.displacement) > 0)
                {
                    out.x = plane.point.x + push.displacement.x / 2 + search.origin.x;
                    out.y = plane.point.y + push.displacement.y / 2 + search.origin.y;
                    out.z = plane.point.z + push.displacement.z / 2 + search.origin.z;
                    out.isDeepestOfA = plane.isPointOfModel;
                    if (_exits.isDepthProven(search.grid, out))
                    {
                        return true;
                    }
                }
            }
            return false;
        }
    }
}
