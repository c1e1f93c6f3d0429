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
     * a structure or a tree. The normals of contacts point out of the ground.
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
        private var _depths:GroundDepthQuery = new GroundDepthQuery(_pieces);

        // The motion of the search for the first touch, and bounds of the ground's heights.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _range:HeightRange = new HeightRange();

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

        /** Whether a piece of the model overlaps the surface by more than a depth, or a point of it is as deep under the ground. */
        public function isDeeper(depth:Number):Boolean
        {
            return _depths.isDeeper(depth);
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pieces.placeAt(motion, time);
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                if (_pieces.isUnder(0))
                {
                    return true;
                }
                while (_pieces.nextTriangle())
                {
                    if (!_pieces.pair.stayApart(RelativeMotion.NONE) && _pieces.pair.areTouching())
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
            _pieces.placeAt(motion, 0);
            _pieces.begin(motion, 0);
            while (first > 0 && _pieces.nextPiece())
            {
                while (first > 0 && _pieces.nextTriangle())
                {
                    findTime();
                    if (_sweep.time < first)
                    {
                        first = _pieces.box.latest = _sweep.time;
                        if (out != null)
                        {
                            _pieces.pair.findContact(_sweep, out);
                            _pieces.pair.leadOutside(_sweep, out);
                        }
                    }
                }
            }
            motion.time = first;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                out.clearGround();
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
            _pieces.placeAt(motion, time);
            if (!_depths.find(out))
            {
                findOuterContact(out);
            }
        }

        /**
         * Finds the planes of triangles that the standing structure around the model is behind: of planes with nearly the same direction, the one
         * that it is least behind. If the contact has a triangle of the ground, only planes that this triangle is not in front of count.
         *
         * @param contact of the model and the ground, here or near here
         * @param maxDistance how far away triangles may be
         * @param exits receives the contacts that lead out of the planes
         * @return their number
         */
        public function findExits(contact:ContactPoint, maxDistance:Number, exits:Vector.<ContactPoint>):int
        {
            return _depths.findExits(contact.ground, maxDistance, exits);
        }

        /** Finds the contact that lifts the model from its lowest place above all ground under it. */
        public function findOuterContact(out:ContactPoint):void
        {
            var box:GroundBox = _pieces.box;
            _pieces.placeBox();
            var low:Number = box.z - box.halfZ;
            _pieces.grid.findAround(box.x + box.origin.x, box.y + box.origin.y, box.halfX, box.halfY, _range);
            out.setNormal(0, 0, 1);
            out.depth = Math.max(0, _range.greatest - box.origin.z - low);
            out.x = box.x;
            out.y = box.y;
            out.z = low + out.depth / 2;
            out.clearGround();
            _pieces.moveToWorld(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         * @param out receives the distance and the points, in the world
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            var box:GroundBox = _pieces.box;
            findNearest(out);
            if (!_pieces.hasTree)
            {
                _pieces.beginAt(_nearest);
                keepCloser(out);
            }
            _pieces.begin(RelativeMotion.NONE, out.distance);
            while (_pieces.nextPiece())
            {
                keepCloser(out);
            }
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _pieces.grid.heightAt(out.aX + box.origin.x, out.aY + box.origin.y) - box.origin.z >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
            out.place(box.origin);
        }

        // Finds the point of the grid that is nearest to the model's middle, seen from above. The model is at most as far as its farthest point is
        // from there, so the distance begins with that.
        private function findNearest(out:ClosestPoints):void
        {
            var box:GroundBox = _pieces.box;
            _pieces.placeBox();
            _nearest.x = box.x + box.origin.x;
            _nearest.y = box.y + box.origin.y;
            _pieces.grid.findNearest(_nearest);
            var x:Number = Math.abs(_nearest.x - box.origin.x - box.x) + box.halfX;
            var y:Number = Math.abs(_nearest.y - box.origin.y - box.y) + box.halfY;
            var z:Number = Math.abs(_nearest.height - box.origin.z - box.z) + box.halfZ;
            out.distance = Math.sqrt(x * x + y * y + z * z) * Tolerances.OUTER + Tolerances.SURFACES * _pieces.grid.cellWidth;
        }

        // Measures the distances of the piece and the triangles near it, and keeps the closest points.
        private function keepCloser(out:ClosestPoints):void
        {
            while (_pieces.nextTriangle())
            {
                if (_pieces.pair.findCloser(out))
                {
                    _pieces.box.maxDistance = out.distance;
                }
            }
        }

        // Finds when the moving piece touches the triangle, until the latest time.
        private function findTime():void
        {
            _sweep.latest = _pieces.box.latest;
            _sweep.time = RelativeMotion.NEVER;
            if (!_pieces.pair.stayApart(_sweep))
            {
                _pieces.pair.findTime(_sweep);
            }
        }
    }
}
