package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.solid.ModelTree;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     * An inner node is divided if the surface comes near it. Otherwise it has no triangles, and stands for all pieces inside of it.
     *
     * <p>After <code>begin()</code>, <code>next()</code> goes through the pairs. If the pieces count too, <code>nextPiece()</code> goes through them, and
     * <code>nextTriangle()</code> through the triangles near the current one. The limits may be narrowed meanwhile.</p>
     */
    internal final class PieceTrianglePairs
    {
        /** The pieces. A query may move the model before it begins. */
        public var pieces:ModelPieces = new ModelPieces();

        /**
         * The search for the triangles near the current piece. Its origin is the place that the model was set to: pieces, triangles and contacts are
         * relative to it. Read only.
         */
        public var search:GroundSearch = new GroundSearch();

        private var _triangles:NearTriangles = new NearTriangles(search, pieces);

        // The ground under a point of the current piece, its normal there, and the piece's lowest point along this normal, relative to the origin.
        private var _under:GroundPoint = new GroundPoint();
        private var _normal:Vector3D = new Vector3D();
        private var _point:Vector3D = new Vector3D();

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            search.grid = grid;
            search.origin.x = placement.x;
            search.origin.y = placement.y;
            search.origin.z = placement.z;
            pieces.setTo(tree, structure, placement, depth);
        }

        /** The current triangle of the ground. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
        }

        /**
         * Begins.
         *
         * @param motion of the pieces from where they are: triangles count that they may meet until its latest time. It is kept, and the caller may
         *     make its latest time earlier
         * @param maxDistance triangles count that are at most this far away; 0 if the pieces move
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            pieces.begin();
            search.motion = motion;
            search.maxDistance = maxDistance;
            search.minDepth = 0;
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
                _triangles.begin();
                if (pieces.kind != ModelPieces.INNER_NODE || !_triangles.next())
                {
                    return true;
                }
                pieces.divide();
            }
            return false;
        }

        /** Whether a point of the current piece is at least this deep under the ground. */
        public function hasPointUnder(depth:Number):Boolean
        {
            return isUnder(pieces.point, depth, _under);
        }

        /**
         * Whether a quick test shows that a part of the current piece is under the ground: its point, or a structure's lowest point along the ground's
         * normal. This shows it of nearly all structures whose lowest part is there.
         */
        public function isPartUnder():Boolean
        {
            if (isUnder(pieces.point, 0, _under))
            {
                return true;
            }
            if (!pieces.hasShapeInBox)
            {
                return false;
            }
            var shape:ConvexShape = pieces.kernel.shape;
            search.grid.findNormal(_under, _normal);
            var at:int = shape.support(_normal, -1);
            _point.x = shape.x + shape.points[at] - shape.radius * _normal.x;
            _point.y = shape.y + shape.points[int(at + 1)] - shape.radius * _normal.y;
            _point.z = shape.z + shape.points[int(at + 2)] - shape.radius * _normal.z;
            return isUnder(_point, 0, _under);
        }

        // Finds the ground under a point. Returns whether the point is at least so deep under it.
        private function isUnder(point:Vector3D, depth:Number, outGround:GroundPoint):Boolean
        {
            outGround.x = point.x + search.origin.x;
            outGround.y = point.y + search.origin.y;
            search.grid.findHeight(outGround);
            return outGround.height - depth >= point.z + search.origin.z;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (!_triangles.next())
            {
                return false;
            }
            pieces.ensureShape();
            // SquareSeparation may read the margin of any triangle: none is more than its slack
            pieces.kernel.shape.margin = pieces.shapeMargin + _triangles.triangle.margin;
            return true;
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += search.origin.x;
            contact.y += search.origin.y;
            contact.z += search.origin.z;
        }
    }
}
