package starlogo.ground
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.solid.ImpactQuery;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Tests a placed model against the ground: whether the two overlap, when and how they first touch, and how far they are apart. The model is
     * a structure or a tree. The normals of contacts point out of the ground. <code>penetration</code> says how deep the model is.
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
        private var _pairs:PieceTrianglePairs = new PieceTrianglePairs();

        /** Finds how deep the model is in the ground. */
        public var penetration:GroundPenetrationQuery = new GroundPenetrationQuery(_pairs);

        // The motion of the search for the first touch. It begins where the model is, because the model is moved to the beginning.
        private var _sweep:RelativeMotion = new RelativeMotion();

        // The point of the ground from which a search for the distance begins.
        private var _nearest:GroundPoint = new GroundPoint();

        /**
         * Sets the model and the ground. Call it before each question, because a question may leave the model where its motion has brought it.
         *
         * @param grid the ground
         * @param tree the model's tree; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether triangles decide in place of depths, if the tree has triangles
         */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _pairs.setTo(grid, tree, structure, placement, depth, exact);
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pairs.moveModelTo(motion, time);
            _pairs.begin(RelativeMotion.NONE, 0);
            while (_pairs.nextPiece())
            {
                if (_pairs.isUnder(0))
                {
                    return true;
                }
                while (_pairs.nextTriangle())
                {
                    if (!_pairs.side.stayApart(RelativeMotion.NONE) && _pairs.kernel.areTouching(_pairs.triangle.corners, 0))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            var first:Number = RelativeMotion.NEVER;
            _sweep.copyVector(motion);
            _sweep.earliest = motion.earliest;
            _sweep.latest = motion.latest;
            _pairs.moveModelTo(motion, 0);
            _pairs.begin(motion, 0);
            while (first > 0 && _pairs.next())
            {
                _sweep.time = RelativeMotion.NEVER;
                if (!_pairs.side.stayApart(_sweep))
                {
                    _pairs.kernel.findTime(_pairs.triangle.corners, 0, _sweep);
                }
                if (_sweep.time < first)
                {
                    first = _sweep.latest = _sweep.time;
                    _pairs.search.latest = first;
                    if (out != null)
                    {
                        _pairs.kernel.findContact(_pairs.triangle.corners, 0, _sweep, out);
                        _pairs.side.leadOutside(_sweep, out);
                    }
                }
            }
            motion.time = first;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                out.resetProof();
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
                findImpact(motion, out);
                var isSame:Boolean = motion.time <= time + Tolerances.SAME_TIME;
                motion.time = time;
                if (isSame)
                {
                    return;
                }
            }
            _pairs.moveModelTo(motion, time);
            penetration.findContact(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            var origin:Placement = _pairs.search.origin;
            findNearest(out);
            if (!_pairs.hasTree)
            {
                _pairs.begin(RelativeMotion.NONE, 0);
                _pairs.nextPiece();
                _pairs.narrowTo(_nearest);
                keepCloser(out);
            }
            _pairs.begin(RelativeMotion.NONE, out.distance);
            keepCloser(out);
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _pairs.search.grid.heightAt(out.aX + origin.x, out.aY + origin.y) - origin.z >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.correct(areTouching);
            out.place(origin);
        }

        // Finds the point of the grid that is nearest to the model's middle, seen from above. The model is at most as far as its farthest point is
        // from there, so the distance begins with that.
        private function findNearest(out:ClosestPoints):void
        {
            var origin:Placement = _pairs.search.origin;
            var box:GroundBox = _pairs.wholeBox();
            _nearest.x = box.x + origin.x;
            _nearest.y = box.y + origin.y;
            _pairs.search.grid.findNearest(_nearest);
            var x:Number = Math.abs(_nearest.x - origin.x - box.x) + box.halfX;
            var y:Number = Math.abs(_nearest.y - origin.y - box.y) + box.halfY;
            var z:Number = Math.abs(_nearest.height - origin.z - box.z) + box.halfZ;
            out.distance = Math.sqrt(x * x + y * y + z * z) * Tolerances.OUTER + Tolerances.SURFACES * _pairs.search.grid.cellWidth;
        }

        // Finds the closest points of all pairs.
        private function keepCloser(out:ClosestPoints):void
        {
            while (_pairs.next())
            {
                if (_pairs.kernel.findCloser(_pairs.triangle.corners, 0, out))
                {
                    _pairs.search.maxDistance = out.distance;
                }
            }
        }
    }
}
