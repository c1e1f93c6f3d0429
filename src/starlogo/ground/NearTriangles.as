package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;

    /**
     * The triangles of the ground near a piece of a model, one after the other.
     *
     * <p>The triangles near an inner node that comes to few cells are found once, and kept for the pieces inside of it: each box is tested against them.
     * If the pieces of a leaf are triangles, those near the leaf's box are chosen first, and only these are tested.</p>
     */
    internal final class NearTriangles
    {
        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:GroundTriangle = null;

        private var _search:GroundSearch;
        private var _pieces:ModelPieces;
        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles so far. If they are not kept, the first one is overwritten. The list grows during the first searches, up to the triangles of few
        // cells. So later frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _count:int = 0;

        // Whether they are kept, until fewer nodes are left than when the search began.
        private var _areKept:Boolean = false;
        private var _nodesLeftAtSearch:int = 0;

        // Those near the box of the current leaf. They are chosen if a triangle of the leaf is the current piece.
        private var _leafTriangles:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _leafTriangleCount:int = 0;
        private var _isInLeaf:Boolean = false;

        // The place of the next triangle in the list of the current piece.
        private var _next:int = 0;

        // The box around the whole motion of the current piece, or of the leaf around it.
        private var _box:GroundBox = new GroundBox();

        /**
         * @param search what is looked for, but for its box and shape. Before pieces begin, all of it is set. Then only the limits may be narrowed
         * @param pieces has the current piece
         */
        public function NearTriangles(search:GroundSearch, pieces:ModelPieces)
        {
            _search = search;
            _pieces = pieces;
        }

        /** Ends: there is no next triangle. */
        public function stop():void
        {
            _source.stop();
            _areKept = _isInLeaf = false;
            _next = _count = 0;
        }

        /** Begins with the current piece. */
        public function begin():void
        {
            var isLeafTriangle:Boolean = _pieces.kind == ModelPieces.TRIANGLE && _areKept;
            _next = 0;
            if (!isLeafTriangle)
            {
                beginWithBox();
            }
            else if (!_isInLeaf)
            {
                chooseForLeaf();
            }
            _isInLeaf = isLeafTriangle;
        }

        // Begins to go through the triangles near the box of the current piece.
        private function beginWithBox():void
        {
            if (_pieces.kind == ModelPieces.TRIANGLE)
            {
                _box.setToTriangle(_pieces.corners);
                _box.grow(_pieces.shapeMargin);
            }
            else
            {
                _box.copyFrom(_pieces.box);
            }
            if (!_areKept || _pieces.nodesLeft < _nodesLeftAtSearch)
            {
                beginSearch();
            }
            if (!_search.motion.isStill)
            {
                _box.extendAlong(_search.motion);
            }
        }

        // Begins to find the triangles near the box of the current piece.
        private function beginSearch():void
        {
            _search.box.copyFrom(_box);
            _search.shape = _pieces.hasShapeInBox ? _pieces.kernel.shape : null;
            _source.begin(_search);
            _areKept = _pieces.kind == ModelPieces.INNER_NODE && _source.beginsAtCells();
            _nodesLeftAtSearch = _pieces.nodesLeft;
            _count = 0;
        }

        // Chooses the triangles near the box of the current leaf, whose first triangle is the current piece.
        private function chooseForLeaf():void
        {
            _leafTriangleCount = 0;
            while (nextFound())
            {
                _leafTriangles[_leafTriangleCount] = triangle;
                _leafTriangleCount++;
            }
            _next = 0;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function next():Boolean
        {
            if (!_isInLeaf)
            {
                return nextFound();
            }
            while (_next < _leafTriangleCount)
            {
                triangle = _leafTriangles[_next];
                _next++;
                if (!isInFront(triangle))
                {
                    return true;
                }
            }
            return false;
        }

        // Goes on to the next triangle near the box.
        private function nextFound():Boolean
        {
            while (_next < _count || findMore())
            {
                triangle = _found[_next];
                _next++;
                if (isNear(triangle))
                {
                    return true;
                }
            }
            return false;
        }

        // Finds one more triangle. Returns false if there is none.
        private function findMore():Boolean
        {
            if (!_areKept)
            {
                _count = _next = 0;
            }
            if (_count == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            if (!_source.next(_found[_count]))
            {
                return false;
            }
            _found[_count].prepare(_source);
            _count++;
            return true;
        }

        // Whether a triangle is near the box: the box comes near the triangle's own box, and is not all in front of its plane.
        private function isNear(triangle:GroundTriangle):Boolean
        {
            var box:GroundBox = _box;
            var other:GroundBox = triangle.box;
            var maxDistance:Number = _search.maxDistance;
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
            return !(normal.x * x + normal.y * y + normal.z * z - triangle.plane.max > maxDistance - _search.minDepth + _source.slack);
        }

        // Whether the current piece, a triangle of the model, is all in front of a triangle's plane.
        private function isInFront(triangle:GroundTriangle):Boolean
        {
            var corners:Vector.<Number> = _pieces.corners;
            var normal:Vector3D = triangle.plane.normal;
            var motion:RelativeMotion = _search.motion;
            var least:Number = normal.x * corners[0] + normal.y * corners[1] + normal.z * corners[2];
            var other:Number = normal.x * corners[3] + normal.y * corners[4] + normal.z * corners[5];
            least = other < least ? other : least;
            other = normal.x * corners[6] + normal.y * corners[7] + normal.z * corners[8];
            least = other < least ? other : least;
            var travel:Number = (normal.x * motion.x + normal.y * motion.y + normal.z * motion.z) * motion.latestTime;
            least = travel < 0 ? least + travel : least;
            return least - triangle.plane.max > _search.maxDistance - _search.minDepth + _pieces.shapeMargin + _source.slack;
        }
    }
}
