package starlogo.ground
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.FirstImpact;
    import starlogo.solid.ImpactQuery;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Tests a placed model against the ground: whether the two overlap, when and how they first touch, and how far they are apart. The model is
     * a structure or a tree. The normals of contacts point out of the ground.
     *
     * <p>A connected piece that does not touch the ground's surface is wholly under the ground or wholly outside of it, so one point decides.
     * So each convex piece is tested against the triangles of the surface near it, and a point of it against the height of the ground.</p>
     *
     * <p>Answers are nested, because a node's piece contains the pieces and the triangles of all its descendants.</p>
     *
     * @private
     */
    public final class GroundModelQuery extends ImpactQuery
    {
        /** Asks how deep the model is in the ground where it stands. Read only. */
        public var penetration:GroundPenetrationQuery;

        // Longer than any distance in the world.
        private static const FARTHEST:Number = 8 * Placement.LARGEST_COORDINATE;

        private var _pairs:PieceTrianglePairs = new PieceTrianglePairs();
        private var _deepest:DeepestPointSearch = new DeepestPointSearch();
        private var _pushSearch:GroundPushSearch = new GroundPushSearch();

        // The motion until the first touch so far. It begins where the model is, because the model is moved to the beginning.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _firstImpact:FirstImpact = new FirstImpact();

        // A place near the end of a push, as the start of a motion.
        private var _end:RelativeMotion = new RelativeMotion();

        public function GroundModelQuery()
        {
            penetration = new GroundPenetrationQuery(_pairs);
        }

        /**
         * Sets the model and the ground. Call it before each question, because a question may leave the model where its motion has brought it.
         *
         * @param grid the ground
         * @param tree the model's tree; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited; BoxTree.EXACT if its triangles decide
         */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            _pairs.setTo(grid, tree, structure, placement, depth);
        }

        /** @inheritDoc */
        override public function areTouchingAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pairs.piece.moveTo(motion, time);
            return areTouching();
        }

        // Whether the two touch where the model is. areTouchingAt() is short so that V8 inlines it and allocates no object for the time.
        private function areTouching():Boolean
        {
            if (_deepest.isPointUnder(_pairs.piece, _pairs.search))
            {
                return true;
            }
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.nextPiece())
            {
                if (_pairs.hasPointUnder(0) || touchesTriangle())
                {
                    return true;
                }
            }
            return false;
        }

        // Whether the current piece touches a triangle near it.
        private function touchesTriangle():Boolean
        {
            var kernel:TriangleKernel = _pairs.piece.kernel;
            while (_pairs.nextTriangle())
            {
                var near:GroundTriangle = _pairs.triangle;
                if (!near.plane.areApart(kernel.shape, RelativeMotion.NONE) && kernel.areTouching(near.corners))
                {
                    return true;
                }
            }
            return false;
        }

        /**
         * Finds the contact of a push out of the ground, by planes alone (GroundPushSearch).
         *
         * @param probe the two touch so far before the end of the push, and are apart so far behind it
         * @param out receives the contact, in the world
         * @return whether there is one
         */
        public function findPush(probe:Number, out:ContactPoint):Boolean
        {
            return _pushSearch.find(_pairs.piece, _pairs.search, probe, out) && (_pushSearch.isFree || !areTouchingAfter(out, probe))
                && (out.isDeepestOfA || areTouchingAfter(out, -probe));
        }

        // Whether the two touch after a push, and a little farther.
        private function areTouchingAfter(push:ContactPoint, farther:Number):Boolean
        {
            _end.startX = (push.depth + farther) * push.normalX;
            _end.startY = (push.depth + farther) * push.normalY;
            _end.startZ = (push.depth + farther) * push.normalZ;
            return areTouchingAt(_end, 0);
        }

        /** @inheritDoc */
        override public function findImpactOfSurfaces(motion:RelativeMotion, out:ContactPoint):void
        {
            var kernel:TriangleKernel = _pairs.piece.kernel;
            var sweep:RelativeMotion = _sweep;
            sweep.copyVector(motion);
            sweep.earliestTime = motion.earliestTime;
            sweep.latestTime = motion.latestTime;
            _firstImpact.reset();
            _pairs.piece.moveTo(motion, 0);
            _pairs.begin(sweep, 0);
            while (_firstImpact.time > 0 && _pairs.next())
            {
                var near:GroundTriangle = _pairs.triangle;
                if (near.plane.areApart(kernel.shape, sweep))
                {
                    continue;
                }
                kernel.findTimeOfImpact(near.corners, sweep);
                if (_firstImpact.offer(sweep, near.plane) && out != null)
                {
                    sweep.time = _firstImpact.time;
                    kernel.findContact(near.corners, sweep, out);
                    near.plane.leadOutside(kernel.shape, sweep, out);
                    near.plane.alignContact(kernel.shape, sweep, out);
                }
            }
            motion.time = _firstImpact.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                // an overlap's contact may be deep, and is turned; then its deepest point need not be of the model
                out.forgetDeepest();
                out.isDeepestOfA = motion.time > 0;
                _pairs.moveToWorld(out);
            }
        }

        /**
         * If the moving model first touches the surface then, it is the contact of this touch. Otherwise it is the contact of the deepest piece,
         * where the model stands then. If the model is wholly under the ground, the contact lifts it up.
         *
         * @inheritDoc
         */
        override public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
            if (!motion.isStill)
            {
                findImpactOfSurfaces(motion, out);
                var isSame:Boolean = motion.time <= time + Tolerances.SAME_TIME;
                motion.time = time;
                if (isSame)
                {
                    return;
                }
            }
            _pairs.piece.moveTo(motion, time);
            penetration.findContact(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points. The search goes only as far as a cell is wide, and twice as
         * far if there is no ground so near.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            var origin:Placement = _pairs.search.origin;
            var kernel:TriangleKernel = _pairs.piece.kernel;
            var isFound:Boolean = false;
            for (var limit:Number = _pairs.search.grid.cellWidth; !isFound && limit < FARTHEST; limit *= 2)
            {
                out.distance = limit;
                _pairs.begin(RelativeMotion.NONE, limit);
                while (_pairs.next())
                {
                    if (kernel.findCloser(_pairs.triangle.corners, out))
                    {
                        isFound = true;
                        _pairs.search.maxDistance = out.distance;
                    }
                }
            }
            if (!isFound)
            {
                out.distance = Infinity;
            }
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _pairs.search.grid.heightAt(out.a.x + origin.x, out.a.y + origin.y) - origin.z >= out.a.z;
                out.setPoint(isUnder ? out.a : out.b);
            }
            out.correct(areTouching);
            out.placePoints(origin);
        }
    }
}
