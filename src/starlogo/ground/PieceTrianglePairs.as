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
     *
     * <p>A GroundTriangles finds the triangles near a box. There are three cases:</p>
     *
     * <ul>
     * <li>A piece has its own search, and its triangles are tested as they are found.</li>
     * <li>An inner node comes to few cells. Its triangles are kept, and the box of each piece inside of it is tested against them.</li>
     * <li>A leaf is inside of such a node, and its pieces are triangles. Of the kept triangles those near the leaf's box are chosen, and each piece is
     * tested against these by their planes.</li>
     * </ul>
     */
    internal final class PieceTrianglePairs
    {
        /** The pieces. A query may move the model before it begins. */
        public var pieces:ModelPieces = new ModelPieces();

        /** The current triangle of the ground. Read only. */
        public var triangle:GroundTriangle = null;

        /**
         * The search for the triangles near the current piece. Its origin is the place that the model was set to: pieces, triangles and contacts are
         * relative to it. Read only.
         */
        public var search:GroundSearch = new GroundSearch();

        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles that the search has found so far. If they are not kept, the first one is overwritten. The list grows during the first searches, up
        // to the triangles of few cells. So later frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _foundCount:int = 0;

        // Whether they are kept for all pieces inside of an inner node, and how many nodes come after these pieces.
        private var _areKept:Boolean = false;
        private var _nodesAfterKept:int = 0;

        // Those near the box of the leaf that was divided last, if they were kept.
        private var _leafTriangles:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _leafTriangleCount:int = 0;

        // The place of the next triangle in the list that the current piece is tested against.
        private var _next:int = 0;

        // The box around the whole motion of the current piece, or of the leaf around it.
        private var _box:GroundBox = new GroundBox();

        // The ground under a point of the current piece, and its normal there.
        private var _under:GroundPoint = new GroundPoint();
        private var _normal:Vector3D = new Vector3D();

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            search.grid = grid;
            search.origin.x = placement.x;
            search.origin.y = placement.y;
            search.origin.z = placement.z;
            pieces.setTo(tree, structure, placement, depth);
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
            _source.stop();
            _areKept = false;
            _next = _foundCount = 0;
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
                _next = 0;
                // the found triangles are kept until the pieces inside of their node are through
                _areKept = _areKept && pieces.nodesLeft >= _nodesAfterKept;
                if (!isTriangleOfLeaf)
                {
                    beginWithBox();
                }
                if (pieces.kind != ModelPieces.INNER_NODE || !nextNearBox())
                {
                    return true;
                }
                if (pieces.divide() && _areKept)
                {
                    chooseForLeaf();
                }
            }
            return false;
        }

        // Whether the current piece is tested against the triangles that are chosen for its leaf.
        private function get isTriangleOfLeaf():Boolean
        {
            return _areKept && pieces.kind == ModelPieces.TRIANGLE;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            var isNear:Boolean = isTriangleOfLeaf ? nextNotInFront() : nextNearBox();
            if (isNear)
            {
                // SquareSeparation may read the margin of any triangle: none is more than its slack
                pieces.kernel.shape.margin = pieces.shapeMargin + triangle.margin;
            }
            return isNear;
        }

        // Begins to go through the triangles near the box of the current piece.
        private function beginWithBox():void
        {
            if (pieces.kind == ModelPieces.TRIANGLE)
            {
                _box.setToTriangle(pieces.corners);
                _box.grow(pieces.shapeMargin);
            }
            else
            {
                _box.copyFrom(pieces.box);
            }
            if (!_areKept)
            {
                beginSearch();
            }
            if (!search.motion.isStill)
            {
                _box.extendAlong(search.motion);
            }
        }

        // Begins to find the triangles near the box of the current piece.
        private function beginSearch():void
        {
            search.box.copyFrom(_box);
            search.shape = pieces.hasShapeInBox ? pieces.kernel.shape : null;
            _source.begin(search);
            _areKept = pieces.kind == ModelPieces.INNER_NODE && _source.beginsAtCells();
            _nodesAfterKept = pieces.nodesLeft;
            _foundCount = 0;
        }

        // Chooses the triangles near the box of the current piece, a leaf.
        private function chooseForLeaf():void
        {
            _next = 0;
            _leafTriangleCount = 0;
            while (nextNearBox())
            {
                _leafTriangles[_leafTriangleCount] = triangle;
                _leafTriangleCount++;
            }
        }

        // Goes on to the next triangle of those chosen for the leaf that the current piece, a triangle, is not all in front of.
        private function nextNotInFront():Boolean
        {
            while (_next < _leafTriangleCount)
            {
                triangle = _leafTriangles[_next];
                _next++;
                if (!isInFront())
                {
                    return true;
                }
            }
            return false;
        }

        // Goes on to the next triangle near the box.
        private function nextNearBox():Boolean
        {
            while (_next < _foundCount || findOneMore())
            {
                triangle = _found[_next];
                _next++;
                if (isNearBox())
                {
                    return true;
                }
            }
            return false;
        }

        // Finds one more triangle. Returns false if there is none.
        private function findOneMore():Boolean
        {
            if (!_areKept)
            {
                _foundCount = _next = 0;
            }
            if (_foundCount == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            if (!_source.next(_found[_foundCount]))
            {
                return false;
            }
            _found[_foundCount].prepare(_source);
            _foundCount++;
            return true;
        }

        // Whether the current triangle is near the box: the box comes near the triangle's own box, and is not all in front of its plane.
        private function isNearBox():Boolean
        {
            var box:GroundBox = _box;
            var other:GroundBox = triangle.box;
            var maxDistance:Number = search.maxDistance;
            var x:Number = box.x - other.x;
            var y:Number = box.y - other.y;
            var z:Number = box.z - other.z;
            var farX:Number = box.halfX + other.halfX + maxDistance;
            var farY:Number = box.halfY + other.halfY + maxDistance;
            var farZ:Number = box.halfZ + other.halfZ + maxDistance;
            if (z > farZ || z < -farZ || x > farX || x < -farX || y > farY || y < -farY)
            {
                return false;
            }
            // the corner of the box that is farthest behind the plane
            var normal:Vector3D = triangle.plane.normal;
            x = normal.x > 0 ? box.x - box.halfX : box.x + box.halfX;
            y = normal.y > 0 ? box.y - box.halfY : box.y + box.halfY;
            z = normal.z > 0 ? box.z - box.halfZ : box.z + box.halfZ;
            // a flat triangle has no plane
            return !(normal.x * x + normal.y * y + normal.z * z - triangle.plane.max > maxDistance - search.minDepth + _source.slack);
        }

        // Whether the current piece, a triangle of the model, is all in front of the current triangle's plane.
        private function isInFront():Boolean
        {
            var corners:Vector.<Number> = pieces.corners;
            var normal:Vector3D = triangle.plane.normal;
            var motion:RelativeMotion = search.motion;
            var least:Number = normal.x * corners[0] + normal.y * corners[1] + normal.z * corners[2];
            var other:Number = normal.x * corners[3] + normal.y * corners[4] + normal.z * corners[5];
            least = other < least ? other : least;
            other = normal.x * corners[6] + normal.y * corners[7] + normal.z * corners[8];
            least = other < least ? other : least;
            var travel:Number = (normal.x * motion.x + normal.y * motion.y + normal.z * motion.z) * motion.latestTime;
            least = travel < 0 ? least + travel : least;
            return least - triangle.plane.max > search.maxDistance - search.minDepth + pieces.shapeMargin + _source.slack;
        }

        /** Finds the ground under a point of the current piece. Returns whether the point is at least this deep under it. */
        public function hasPointUnder(depth:Number):Boolean
        {
            _under.x = pieces.point.x + search.origin.x;
            _under.y = pieces.point.y + search.origin.y;
            search.grid.findHeight(_under);
            return _under.height - depth >= pieces.point.z + search.origin.z;
        }

        /**
         * Whether a quick test shows that a part of the current piece is under the ground: its point, or a structure's lowest point along the ground's
         * normal. This shows it of nearly all structures whose lowest part is there.
         */
        public function isPartUnder():Boolean
        {
            if (hasPointUnder(0))
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
            _under.x = shape.origin.x + shape.points[at] - shape.radius * _normal.x + search.origin.x;
            _under.y = shape.origin.y + shape.points[int(at + 1)] - shape.radius * _normal.y + search.origin.y;
            search.grid.findHeight(_under);
            return _under.height >= shape.origin.z + shape.points[int(at + 2)] - shape.radius * _normal.z + search.origin.z;
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
