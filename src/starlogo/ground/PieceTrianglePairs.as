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
     * A divisible piece is divided if the surface comes near it. Otherwise it has no triangles, and stands for all pieces inside of it.
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

        /** The place that the model was set to: pieces, triangles and contacts are relative to it. Read only. */
        public var origin:Placement;

        // Finds triangles near the current piece.
        private var _search:GroundSearch = new GroundSearch();
        private var _triangles:KeptTriangles = new KeptTriangles(_search);

        public function PieceTrianglePairs()
        {
            kernel = pieces.kernel;
            origin = _search.origin;
        }

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _search.grid = grid;
            origin.x = placement.x;
            origin.y = placement.y;
            origin.z = placement.z;
            pieces.setTo(tree, structure, placement, depth, exact);
        }

        /** The ground. */
        public function get grid():HeightGrid
        {
            return _search.grid;
        }

        /** The current triangle of the ground. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
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
            _search.leastDepth = 0;
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
            _search.leastDepth = depth;
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
            var near:GroundTriangle = _triangles.triangle;
            kernel.shape.margin = pieces.margin + near.margin;
            kernel.setTriangle(near.corners, near.plane);
            return true;
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
