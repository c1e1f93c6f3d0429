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
        /** An answer: no push is found. */
        public static const NONE:int = 0;

        /** An answer: there is a push, but only a test of the model's pieces shows whether it leads out. */
        public static const UNKNOWN:int = 1;

        /** An answer: there is a push, and it leads out. */
        public static const FREE:int = 2;

        // Models that are larger than this many cells have other tests, which need not look at all cells.
        private static const MAX_CELLS:Number = 8;

        // A push must be longer than this many times the probe.
        private static const MIN_PROBES:Number = 8;

        // The probe must be longer than this many times the gap across which surfaces touch.
        private static const MIN_MARGINS:Number = 8;

        private var _deepest:DeepestPointSearch;
        private var _planes:GroundPlanes = new GroundPlanes();
        private var _separation:GroundSeparation = new GroundSeparation(_planes);
        private var _exits:GroundExits;

        public function GroundPushSearch(deepest:DeepestPointSearch, exits:GroundExits)
        {
            _deepest = deepest;
            _exits = exits;
        }

        /**
         * Finds the push.
         *
         * @param model where it stands
         * @param search has the ground and the origin
         * @param probe the model is in the ground so far before the end of the push, and is free so far behind it
         * @param out receives the push as a contact, in the world. If no deepest point of the model is known, only a test shows whether the model is in the
         *     ground before the end
         * @return one of the answers
         */
        public function find(model:ModelPiece, search:GroundSearch, probe:Number, out:ContactPoint):int
        {
            var separation:int = GroundSeparation.BLOCKED;
            model.findWholeBox();
            _planes.clear();
            if (!isSmall(model.box, search.grid) || probe < MIN_MARGINS * marginOf(model, search.grid) || !_deepest.beginUnder(model, search, _planes.next))
            {
                return NONE;
            }
            while (separation == GroundSeparation.BLOCKED)
            {
                if (!_planes.hasRoom || !addExits(model, search) || !_planes.solve(probe) || _planes.push.distance <= MIN_PROBES * probe)
                {
                    return NONE;
                }
                separation = _separation.find(model, search, probe / 4);
            }
            if (!findContact(search, probe, out))
            {
                return NONE;
            }
            return separation == GroundSeparation.SEPARATED ? FREE : UNKNOWN;
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

        // Adds the exits of the point that is deepest if one follows the normals from the next plane on. Returns whether the last push does not lead out of them.
        private function addExits(model:ModelPiece, search:GroundSearch):Boolean
        {
            var isFarther:Boolean = false;
            for (var left:int = _deepest.find(model, search, _planes.displacement, _planes.exits, _planes.count); left > 0; left--)
            {
                isFarther ||= _planes.next.frontAfter(_planes.displacement) < _planes.next.offset;
                _planes.add();
            }
            return isFarther;
        }

        // Finds the contact of the push. Its deepest point is one that is under the ground until a little before the end, and of which the depth is proven. Returns
        // whether there is one.
        private function findContact(search:GroundSearch, probe:Number, out:ContactPoint):Boolean
        {
            var push:HalfSpaceSolver = _planes.push;
            var depth:Number = push.distance;
            out.setNormal(push.displacement.x / depth, push.displacement.y / depth, push.displacement.z / depth);
            out.depth = depth;
            out.forget();
            _planes.solve(-probe);
            for (var i:int = 0; i < _planes.count; i++)
            {
                var exit:GroundExit = _planes.exits[i];
                if (exit.heightOver(search, _planes.displacement) > 0)
                {
                    out.x = exit.point.x + push.displacement.x / 2 + search.origin.x;
                    out.y = exit.point.y + push.displacement.y / 2 + search.origin.y;
                    out.z = exit.point.z + push.displacement.z / 2 + search.origin.z;
                    out.isDeepestOfA = exit.isPointOfModel;
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
