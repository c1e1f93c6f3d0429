package starlogo.ground
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;

    /**
     * Finds how deep a standing model is in the ground, and how far up it has to be lifted. GroundModelQuery sets the model.
     *
     * <p>What is behind the plane of a triangle may be outside of the ground, because the plane goes on where the ground is lower. So the depth behind a
     * triangle counts if bounds of the heights around prove that no exit is much shorter. If no depth is proven, the triangle counts that a piece
     * overlaps most.</p>
     *
     * @private
     */
    public final class GroundPenetrationQuery
    {
        // How many rounded terms a depth behind a plane is a sum of, of the shape and of the plane. Each may be off by the triangle's margin.
        private static const TERMS_OF_DEPTH:Number = 10;

        private var _pairs:PieceTrianglePairs;

        // A contact of the current piece and the current triangle.
        private var _tried:ContactPoint = new ContactPoint();

        private var _exits:GroundExits = new GroundExits();

        // Bounds of the heights around the model.
        private var _heightsAround:HeightBounds = new HeightBounds();

        /** @param pairs of the model, where it stands */
        public function GroundPenetrationQuery(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
        }

        /**
         * Finds the contact with the triangle that the model is deepest in. If there is none near, it is wholly under the ground, and the contact lifts it
         * up.
         *
         * @param out receives the contact, in the world
         */
        public function findContact(out:ContactPoint):void
        {
            if (!(findProvenDepth(out) || findLargestOverlap(out)))
            {
                findLift(out);
            }
        }

        /** Finds the contact that lifts the model from its lowest place above all ground under it. */
        public function findLift(out:ContactPoint):void
        {
            var origin:Placement = _pairs.search.origin;
            var box:GroundBox = _pairs.piece.box;
            _pairs.piece.findWholeBox();
            var low:Number = box.z - box.halfZ;
            _pairs.search.grid.pyramid.findAround(box.x + origin.x, box.y + origin.y, box.halfX, box.halfY, _heightsAround);
            out.setNormal(0, 0, 1);
            out.depth = Math.max(0, _heightsAround.max - origin.z - low);
            out.x = box.x;
            out.y = box.y;
            out.z = low + out.depth / 2;
            out.forgetDeepest();
            _pairs.moveToWorld(out);
        }

        /**
         * Whether a piece of the model overlaps the surface by more than a depth, or a point of it is as deep under the ground. An inner node of a tree that
         * is wholly under the ground counts by the middle of its box, which need not be in the model.
         */
        public function isDeeper(depth:Number):Boolean
        {
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.nextPiece())
            {
                var isApart:Boolean = true;
                while (_pairs.nextTriangle())
                {
                    if (findOverlap(_tried))
                    {
                        if (_tried.depth > depth)
                        {
                            return true;
                        }
                        isApart = false;
                    }
                }
                // A structure's middle is inside of it. A tree's piece may be flat, with its middle on the surface. So there it counts only if no triangle touches.
                if ((isApart || _pairs.piece.kind == ModelPiece.STRUCTURE) && _pairs.hasPointUnder(depth))
                {
                    return true;
                }
            }
            return false;
        }

        // Finds the contact with the triangle that the model is deepest behind. Only triangles count that the exit from a piece's deepest point passes
        // through, and only depths that are proven. Returns whether there is one.
        private function findProvenDepth(out:ContactPoint):Boolean
        {
            var isFound:Boolean = false;
            // less than any depth, so that rounding hides no piece that just touches
            out.depth = -Tolerances.SEPARATION * _pairs.search.grid.cellWidth;
            _pairs.beginBehindPlanes();
            while (_pairs.next())
            {
                var near:GroundTriangle = _pairs.triangle;
                near.plane.findBehind(_pairs.piece.kernel.shape, RelativeMotion.NONE, _tried);
                // deeper by more than rounding
                if (_tried.depth >= out.depth + near.margin && isThrough(near.corners, _tried))
                {
                    _pairs.moveToWorld(_tried);
                    if (_exits.isDepthProven(_pairs.search.grid, _tried))
                    {
                        isFound = true;
                        out.copyFrom(_tried);
                        out.isDeepestOfA = true;
                        out.exitBound = GroundExits.MIN_RATIO_PROVEN * out.depth;
                        _pairs.minDepth = out.depth;
                    }
                }
            }
            return isFound;
        }

        // Finds the contact with the triangle that the model overlaps most. Of overlaps that are equally deep, up to rounding, the one with the shorter
        // way out counts: beside a hole, the way past its side, and not the way to the front of the slope at the top of this side. Returns whether
        // there is one.
        private function findLargestOverlap(out:ContactPoint):Boolean
        {
            var isFound:Boolean = false;
            var mostOverlap:Number = 0;
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.next())
            {
                var rounding:Number = roundingHere();
                if (findOverlap(_tried))
                {
                    var overlap:Number = _tried.depth;
                    _pairs.triangle.plane.leadOutside(_pairs.piece.kernel.shape, RelativeMotion.NONE, _tried);
                    var wayOut:Number = _tried.depth;
                    if (!isFound || isBetter(overlap - mostOverlap, wayOut - out.depth, rounding))
                    {
                        isFound = true;
                        mostOverlap = Math.max(overlap, mostOverlap);
                        // no overlap is deeper than the piece is behind the plane, so planes that it is less deep behind no longer count
                        _pairs.minDepth = mostOverlap - rounding;
                        _pairs.moveToWorld(_tried);
                        out.copyFrom(_tried);
                        out.isDeepestOfA = true;
                        out.exitBound = 0;
                    }
                }
            }
            return isFound;
        }

        // Finds the shortest way of the current piece away from the current triangle, into the ground or out of it. Returns whether the two touch.
        private function findOverlap(out:ContactPoint):Boolean
        {
            if (_pairs.triangle.plane.areApart(_pairs.piece.kernel.shape, RelativeMotion.NONE))
            {
                return false;
            }
            _pairs.piece.kernel.findContact(_pairs.triangle.corners, RelativeMotion.NONE, out);
            return out.depth > 0 || _pairs.piece.kernel.areTouching(_pairs.triangle.corners);
        }

        // Whether the exit of a contact behind a triangle's plane passes through the triangle, seen along its normal. False if the triangle is flat.
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

        // Whether an overlap counts in place of another one, from how much deeper it is and how much longer its way out is. If the ways out are clearly
        // different, the overlap with the shorter one counts if the two are equally deep up to rounding.
        private static function isBetter(extraDepth:Number, extraWayOut:Number, rounding:Number):Boolean
        {
            if (Math.abs(extraWayOut) <= rounding)
            {
                return extraDepth > 0;
            }
            return extraWayOut > 0 ? extraDepth > rounding : extraDepth > -rounding;
        }

        // How much a depth behind the current triangle may be off by rounding.
        private function roundingHere():Number
        {
            var origin:Placement = _pairs.search.origin;
            return TERMS_OF_DEPTH * _pairs.triangle.margin + 2 * Touching.marginOfPlace(origin.x, origin.y, origin.z);
        }
    }
}
