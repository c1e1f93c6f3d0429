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
     * a structure or a tree. The normals of contacts point out of the ground. <code>depths</code> says how deep the model is.
     *
     * <p>A connected piece that does not touch the ground's surface is wholly under the ground or wholly outside of it, so one point decides.
     * So each convex piece is tested against the triangles of the surface near it, and a point of it against the height of the ground.</p>
     *
     * <p>Answers are nested, because a node's piece contains the pieces and the triangles of all its
     * descendants.</p>
     *
     * @private
     */
    public final class GroundQuery extends ImpactQuery
    {
        private var _pieces:GroundPieces = new GroundPieces();

        /** Finds how deep the model is in the ground. */
        public var depths:GroundDepthQuery = new GroundDepthQuery(_pieces);

        // The motion of the search for the first touch.
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
            _pieces.setTo(grid, tree, structure, placement, depth, exact);
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pieces.moveModelTo(motion, time);
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                if (_pieces.isUnder(0))
                {
                    return true;
                }
                while (_pieces.nextTriangle())
                {
                    if (!_pieces.kernel.stayApart(RelativeMotion.NONE) && _pieces.kernel.areTouching())
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
            _pieces.moveModelTo(motion, 0);
            _pieces.begin(motion, 0);
            while (first > 0 && _pieces.next())
            {
                _sweep.time = RelativeMotion.NEVER;
                if (!_pieces.kernel.stayApart(_sweep))
                {
                    _pieces.kernel.findTime(_sweep);
                }
                if (_sweep.time < first)
                {
                    first = _sweep.latest = _sweep.time;
                    _pieces.limitTime(first);
                    if (out != null)
                    {
                        _pieces.kernel.findContact(_sweep, out);
                        _pieces.kernel.leadOutside(_sweep, out);
                    }
                }
            }
            motion.time = first;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                out.resetProof();
                _pieces.moveToWorld(out);
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
            _pieces.moveModelTo(motion, time);
            depths.findContact(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            var origin:Placement = _pieces.origin;
            findNearest(out);
            if (!_pieces.hasTree)
            {
                _pieces.beginAtPoint(_nearest);
                keepCloser(out);
            }
            _pieces.begin(RelativeMotion.NONE, out.distance);
            keepCloser(out);
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _pieces.grid.heightAt(out.aX + origin.x, out.aY + origin.y) - origin.z >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
            out.place(origin);
        }

        // Finds the point of the grid that is nearest to the model's middle, seen from above. The model is at most as far as its farthest point is
        // from there, so the distance begins with that.
        private function findNearest(out:ClosestPoints):void
        {
            var origin:Placement = _pieces.origin;
            var box:GroundBox = _pieces.wholeBox();
            _nearest.x = box.x + origin.x;
            _nearest.y = box.y + origin.y;
            _pieces.grid.findNearest(_nearest);
            var x:Number = Math.abs(_nearest.x - origin.x - box.x) + box.halfX;
            var y:Number = Math.abs(_nearest.y - origin.y - box.y) + box.halfY;
            var z:Number = Math.abs(_nearest.height - origin.z - box.z) + box.halfZ;
            out.distance = Math.sqrt(x * x + y * y + z * z) * Tolerances.OUTER + Tolerances.SURFACES * _pieces.grid.cellWidth;
        }

        // Finds the closest points of all pairs.
        private function keepCloser(out:ClosestPoints):void
        {
            while (_pieces.next())
            {
                if (_pieces.kernel.findCloser(out))
                {
                    _pieces.limitDistance(out.distance);
                }
            }
        }
    }
}
