package starlogo.ground
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.intersection.TriangleKernel;

    /**
     * Finds how deep a standing model is in the ground, and how far up it has to be lifted. GroundModelQuery sets the model.
     *
     * <p>What is behind the plane of a triangle may be outside of the ground, because the plane goes on where the ground is lower. So the depth behind a
     * triangle counts if bounds of the heights around prove that no way out is much shorter. If no depth is proven, the triangle counts that a piece
     * overlaps most.</p>
     *
     * @private
     */
    public final class GroundPenetrationQuery
    {
        // A depth is proven if the least length of an exit is at least this fraction of it.
        private static const LEAST_SHARE_PROVEN:Number = 0.8;

        // A depth behind a triangle's plane is off by at most this many margins of the triangle, because of rounding.
        private static const MARGINS_OF_ROUNDING:Number = 10;

        // No contact yet. A depth that counts is at least 0.
        private static const NONE:Number = -1;

        private var _pairs:PieceTrianglePairs;
        private var _kernel:TriangleKernel;

        // A contact of the current piece and the current triangle.
        private var _tried:ContactPoint = new ContactPoint();

        // Bounds of the heights around the model.
        private var _around:HeightRange = new HeightRange();

        /** @param pairs of the model, where it stands */
        public function GroundPenetrationQuery(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
            _kernel = pairs.kernel;
        }

        /**
         * Finds the contact with the triangle that the model is deepest in. If the model meets none, it is wholly under the ground, and the contact
         * lifts it up.
         *
         * @param out receives the contact, in the world
         */
        public function findContact(out:ContactPoint):void
        {
            if (findDeepestBehind(out) || findDeepestOverlap(out))
            {
                _pairs.noteWayOut(out);
                _pairs.moveToWorld(out);
            }
            else
            {
                findLift(out);
            }
        }

        /** Finds the contact that lifts the model from its lowest place above all ground under it. */
        public function findLift(out:ContactPoint):void
        {
            var origin:Placement = _pairs.origin;
            var box:GroundBox = _pairs.pieces.box;
            _pairs.pieces.fitBoxToWhole();
            var low:Number = box.z - box.halfZ;
            _pairs.grid.pyramid.findAround(box.x + origin.x, box.y + origin.y, box.halfX, box.halfY, _around);
            out.setNormal(0, 0, 1);
            out.depth = Math.max(0, _around.greatest - origin.z - low);
            out.x = box.x;
            out.y = box.y;
            out.z = low + out.depth / 2;
            out.leastExit = NaN;
            _pairs.moveToWorld(out);
        }

        /** Whether a piece of the model overlaps the surface by more than a depth, or a point of it is as deep under the ground. */
        public function isDeeper(depth:Number):Boolean
        {
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.nextPiece())
            {
                var isApart:Boolean = true;
                while (_pairs.nextTriangle())
                {
                    if (findOverlap())
                    {
                        if (_tried.depth > depth)
                        {
                            return true;
                        }
                        isApart = false;
                    }
                }
                // the point of a flat piece of a tree may be on the surface
                if ((isApart || !_pairs.pieces.isTree) && _pairs.isUnder(depth))
                {
                    return true;
                }
            }
            return false;
        }

        // Finds the contact with the triangle that the model is deepest behind. Only triangles count that the way out from a piece's deepest point passes
        // through, and only depths that are proven. Returns whether there is one.
        private function findDeepestBehind(out:ContactPoint):Boolean
        {
            var deepest:Number = NONE;
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.next())
            {
                var triangle:GroundTriangle = _pairs.triangle;
                // findDeeper() is off by rounding, so it is asked for a little less than isClearlyDeeper() requires
                _tried.depth = deepest > 0 ? deepest + triangle.margin / 2 : -triangle.margin;
                if (_kernel.plane.findDeeper(_kernel.shape, _tried) && isClearlyDeeper(_tried, deepest) && isThrough(triangle.corners, _tried)
                        && isDepthProven(_tried))
                {
                    deepest = _tried.depth;
                    _pairs.leaveOutShallower(deepest);
                    out.copyFrom(_tried);
                    out.leastExit = LEAST_SHARE_PROVEN * deepest;
                }
            }
            return deepest != NONE;
        }

        // Finds the contact with the triangle that the model overlaps most. Of overlaps that are equally deep, up to rounding, the one with the shorter
        // way out counts: beside a hole, the way past its side, and not the way to the front of the slope at the top of this side. Returns whether
        // there is one.
        private function findDeepestOverlap(out:ContactPoint):Boolean
        {
            var deepest:Number = NONE;
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.next())
            {
                var rounding:Number = roundingHere();
                // no overlap is deeper than the piece is behind the plane
                _kernel.plane.findBehind(_kernel.shape, RelativeMotion.NONE, _tried);
                var isLess:Boolean = deepest > 0 && _tried.depth < deepest - rounding;
                if (!isLess && findOverlap())
                {
                    var depth:Number = _tried.depth;
                    _kernel.plane.leadOutside(_kernel.shape, RelativeMotion.NONE, _tried);
                    if (deepest == NONE || depth > deepest + roundingFor(_tried.depth - out.depth, rounding))
                    {
                        deepest = Math.max(depth, deepest);
                        out.copyFrom(_tried);
                        out.leastExit = 0;
                    }
                }
            }
            return deepest != NONE;
        }

        // Finds the shortest way of the current piece away from the current triangle, into the ground or out of it. Returns whether the two touch.
        private function findOverlap():Boolean
        {
            if (_kernel.planeKeepsApart(RelativeMotion.NONE))
            {
                return false;
            }
            _kernel.findContact(RelativeMotion.NONE, _tried);
            return _tried.depth > 0 || _kernel.areTouching();
        }

        // Whether the way out of a contact behind a triangle's plane passes through the triangle, seen along its normal. False if the triangle is flat.
        private static function isThrough(corners:Vector.<Number>, contact:ContactPoint):Boolean
        {
            var from:int = 6;
            for (var to:int = 0; to < 9; to += 3)
            {
                var ux:Number = corners[to] - corners[from];
                var uy:Number = corners[int(to + 1)] - corners[int(from + 1)];
                var uz:Number = corners[int(to + 2)] - corners[int(from + 2)];
                var vx:Number = contact.x - corners[from];
                var vy:Number = contact.y - corners[int(from + 1)];
                var vz:Number = contact.z - corners[int(from + 2)];
                if (!(contact.normalX * (uy * vz - uz * vy) + contact.normalY * (uz * vx - ux * vz) + contact.normalZ * (ux * vy - uy * vx) >= 0))
                {
                    return false;
                }
                from = to;
            }
            return true;
        }

        // How much deeper an overlap has to be than another one. With a clearly shorter way out it may be as deep up to rounding. With a clearly longer one
        // it has to be clearly deeper.
        private static function roundingFor(longer:Number, rounding:Number):Number
        {
            if (longer > rounding)
            {
                return rounding;
            }
            return longer < -rounding ? -rounding : 0;
        }

        // How much a depth behind the current triangle may be off by rounding.
        private function roundingHere():Number
        {
            var origin:Placement = _pairs.origin;
            return MARGINS_OF_ROUNDING * _pairs.triangle.margin + 2 * Touching.marginOfPlace(origin.x, origin.y, origin.z);
        }

        // Whether a contact is deeper than the deepest one so far by more than rounding.
        private function isClearlyDeeper(contact:ContactPoint, deepest:Number):Boolean
        {
            return deepest > 0 ? contact.depth >= deepest + _pairs.triangle.margin : contact.depth > deepest;
        }

        // Whether each exit from the ground is at least about as long as a contact is deep, because the piece's deepest point has to get out.
        private function isDepthProven(contact:ContactPoint):Boolean
        {
            var depth:Number = contact.depth;
            if (!(depth >= 0))
            {
                return false;
            }
            var origin:Placement = _pairs.origin;
            var x:Number = origin.x + contact.x - depth / 2 * contact.normalX;
            var y:Number = origin.y + contact.y - depth / 2 * contact.normalY;
            var z:Number = origin.z + contact.z - depth / 2 * contact.normalZ;
            return depth == 0 || _pairs.grid.leastExit(x, y, z, depth) >= LEAST_SHARE_PROVEN * depth;
        }
    }
}
