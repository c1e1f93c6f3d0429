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

        private var _triangles:GroundTriangles = new GroundTriangles();

        // The search for triangles near the current piece.
        private var _search:GroundSearch = new GroundSearch();

        // The place of the current piece's point, and the ground there.
        private var _ground:GroundPoint = new GroundPoint();

        public function PieceTrianglePairs()
        {
            _search.box = pieces.box;
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

        /** Decides about the current piece and the current triangle. Both are relative to the origin. Read only. */
        public function get kernel():TriangleKernel
        {
            return pieces.kernel;
        }

        /** The ground. */
        public function get grid():HeightGrid
        {
            return _search.grid;
        }

        /** The place that the model was set to: pieces, triangles and contacts are relative to it. Read only. */
        public function get origin():Placement
        {
            return _search.origin;
        }

        /** The current triangle of the ground. Read only. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
        }

        /**
         * Begins.
         *
         * @param motion of the pieces from where they are: triangles count that they may meet until its latest time. This may become earlier meanwhile
         * @param maxDistance triangles count that are at most this far away
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            pieces.begin();
            _search.motion = motion;
            _search.maxDistance = maxDistance;
        }

        /** From now on only triangles count that are at most this far away. */
        public function leaveOutFarther(maxDistance:Number):void
        {
            _search.maxDistance = maxDistance;
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
                _search.shape = pieces.shapeInBox;
                _triangles.begin(_search);
                if (!pieces.isAbovePieces || !_triangles.next())
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
            kernel.shape.margin = pieces.margin + triangle.margin;
            kernel.setTriangle(triangle.corners);
            return true;
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            _ground.x = pieces.point.x + origin.x;
            _ground.y = pieces.point.y + origin.y;
            grid.findHeight(_ground);
            return _ground.height - depth >= pieces.point.z + origin.z;
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
