package starlogo.ground
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     * A node of a tree that the surface does not come near is a piece without triangles, in place of all pieces below it.
     *
     * <p>After <code>begin()</code>, <code>next()</code> goes through the pairs. If the pieces count too, <code>nextPiece()</code> goes through them, and
     * <code>nextTriangle()</code> through the triangles near the current one. The limits may be narrowed meanwhile.</p>
     */
    internal final class PieceTrianglePairs
    {
        /** The pieces. A query may move the model before it begins. */
        public var pieces:ModelPieces = new ModelPieces();

        /** Decides about the current piece and the current triangle. Both are relative to the origin. Read only. */
        public var kernel:TriangleKernel;

        /** The current triangle of the ground. Read only. */
        public var triangle:GroundTriangle = null;

        /** The ground. Read only. */
        public var grid:HeightGrid = null;

        /** The place that the model was set to: pieces, triangles and contacts are relative to it. Read only. */
        public var origin:Placement;

        // Finds triangles near the current piece.
        private var _triangles:NearTriangles = new NearTriangles();
        private var _search:GroundSearch = _triangles.search;

        // A place under the piece, and the ground there.
        private var _ground:GroundPoint = new GroundPoint();

        // The lowest points of the current piece: along the direction out of the ground below it, and along the normal of the contact that was found last.
        private var _lowest:LowestPoint = new LowestPoint();
        private var _lowestOnWayOut:LowestPoint = new LowestPoint();

        public function PieceTrianglePairs()
        {
            kernel = pieces.kernel;
            origin = _search.origin;
        }

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            this.grid = _search.grid = grid;
            origin.x = placement.x;
            origin.y = placement.y;
            origin.z = placement.z;
            pieces.setTo(tree, structure, placement, depth, exact);
        }

        /**
         * Begins.
         *
         * @param motion of the pieces from where they are: triangles count that they may meet until its latest time. The motion is copied
         * @param maxDistance triangles count that are at most this far away; 0 if the pieces move
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            pieces.begin();
            _search.motion.copyVector(motion);
            _search.motion.latest = motion.latest;
            _search.maxDistance = maxDistance;
            _triangles.leastDepth = 0;
        }

        /** From now on only triangles count that the pieces may meet until a motion's latest time. */
        public function leaveOutLater(motion:RelativeMotion):void
        {
            _search.motion.latest = motion.latest;
        }

        /** From now on only triangles count that are at most this far away. */
        public function leaveOutFarther(maxDistance:Number):void
        {
            _search.maxDistance = maxDistance;
        }

        /** From now on only triangles count behind whose planes the piece, or its box, is at least this deep. */
        public function leaveOutShallower(depth:Number):void
        {
            _triangles.leastDepth = depth;
        }

        /** Goes on to the next triangle near the piece, or near the next piece that has one. Returns false if there is none. */
        public function next():Boolean
        {
            while (!nextTriangle())
            {
                if (!nextPiece())
                {
                    return false;
                }
            }
            return true;
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function nextPiece():Boolean
        {
            while (pieces.next())
            {
                _lowest.isKnown = _lowestOnWayOut.isKnown = false;
                _triangles.begin(pieces.box, pieces.shapeInBox, pieces.nodesLeft);
                if (!pieces.isDivisible || !_triangles.next())
                {
                    return true;
                }
                pieces.divide();
            }
            return false;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (!_triangles.next())
            {
                return false;
            }
            var near:GroundTriangle = triangle = _triangles.triangle;
            kernel.shape.margin = pieces.margin + near.margin;
            kernel.setTriangle(near.corners, near.plane);
            return true;
        }

        /** Whether the piece touches a triangle near it. It is quicker after <code>reachesUnder()</code>. */
        public function touchesTriangle():Boolean
        {
            while (nextTriangle())
            {
                if (!isBelowPiece() && !kernel.planeKeepsApart(RelativeMotion.NONE) && !isBelowOnWayOut() && kernel.areTouching())
                {
                    return true;
                }
            }
            return false;
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            _ground.x = pieces.point.x + origin.x;
            _ground.y = pieces.point.y + origin.y;
            grid.findHeight(_ground);
            return _ground.height - depth >= pieces.point.z + origin.z;
        }

        /**
         * Whether one of two points of the piece is under the ground. If not, only triangles decide whether the piece touches it. The second point is
         * the lowest one above the slope below the first. Nearly all pieces that reach under the ground do so there.
         */
        public function reachesUnder():Boolean
        {
            if (isUnder(0))
            {
                return true;
            }
            if (pieces.isDivisible)
            {
                return false;
            }
            grid.findDirectionOut(_ground, _lowest.up);
            _lowest.find(kernel.shape);
            _ground.x = _lowest.x + origin.x;
            _ground.y = _lowest.y + origin.y;
            grid.findHeight(_ground);
            return _ground.height >= _lowest.z + origin.z;
        }

        // Whether the triangle is clearly below all of the piece, along the direction out of the ground. This direction is known after reachesUnder();
        // before, the answer is false.
        private function isBelowPiece():Boolean
        {
            return _lowest.isKnown && _lowest.isAbove(triangle.corners, kernel.shape);
        }

        // Whether the triangle is clearly below all of the piece, along the normal of the last contact. A model that is tried along its way out is
        // above nearly all triangles there.
        private function isBelowOnWayOut():Boolean
        {
            if (!_lowestOnWayOut.isKnown)
            {
                _lowestOnWayOut.find(kernel.shape);
            }
            return _lowestOnWayOut.isAbove(triangle.corners, kernel.shape);
        }

        /** Notes the normal of a contact of the model. It makes later tests quicker, of the model along this way out. No answer depends on it. */
        public function noteWayOut(contact:ContactPoint):void
        {
            _lowestOnWayOut.isKnown = false;
            _lowestOnWayOut.up.x = contact.normalX;
            _lowestOnWayOut.up.y = contact.normalY;
            _lowestOnWayOut.up.z = contact.normalZ;
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += origin.x;
            contact.y += origin.y;
            contact.z += origin.z;
        }
    }
}
