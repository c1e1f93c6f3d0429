package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.solid.ModelTree;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     * An inner node is divided if the surface comes near it. Otherwise it has no triangles, and stands for all pieces inside of it.
     *
     * <p>After <code>begin()</code>, <code>next()</code> goes through the pairs. If the pieces count too, <code>nextPiece()</code> goes through them, and
     * <code>nextTriangle()</code> through the triangles near the current one. The limits may be narrowed meanwhile.</p>
     *
     * <p>A GroundTriangles finds the triangles near the box of a piece, square by square. An inner node whose box comes to few cells lists them. Each
     * piece inside of it lists those near its own box in turn, chosen from the list of the node around it.</p>
     */
    internal final class PieceTrianglePairs
    {
        /** The current piece. A query may move the model before it begins. */
        public var piece:ModelPiece = new ModelPiece();

        /** The current triangle of the ground. Read only. */
        public var triangle:GroundTriangle = null;

        /**
         * The search for the triangles near the current piece. Its origin is the place that the model was set to: pieces, triangles and contacts are
         * relative to it. Read only.
         */
        public var search:GroundSearch = new GroundSearch();

        /** A limit: how deep a piece must be behind a triangle's plane. Triangles of which it clearly is not are left out. */
        public var minDepth:Number = 0;

        // Whether the pairs are for depths behind planes.
        private var _isForDepths:Boolean = false;

        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles that the search has found near an inner node. Near any other piece, it writes each to the first one. Later searches use the same objects,
        // so frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new <GroundTriangle>[new GroundTriangle()];

        // The lists of triangles of the nodes around the current piece, the outermost one's first, and then its own. _listBegin and _listEnd say where the
        // list of the node around it is: both are 0 if there is none. _next and _end say where the rest of its own list is.
        private var _lists:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _listBegin:int = 0;
        private var _listEnd:int = 0;
        private var _next:int = 0;
        private var _end:int = 0;

        // The pieces that come next, from the last one on. Each has three numbers: its node, or -1 - i for the tree's triangle i; and where the list of the node
        // around it begins and ends.
        private var _waiting:Vector.<int> = new Vector.<int>();
        private var _waitingEnd:int = 0;

        // The box around the whole motion of the current piece.
        private var _swept:GroundBox = new GroundBox();

        // The ground under a point of the current piece, and its normal there.
        private var _under:GroundPoint = new GroundPoint();
        private var _normal:Vector3D = new Vector3D();

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            search.grid = grid;
            // the search is for the current piece, whichever it is
            search.box = piece.box;
            search.origin.x = placement.x;
            search.origin.y = placement.y;
            search.origin.z = placement.z;
            piece.setModel(tree, structure, placement, depth);
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
            search.motion = motion;
            search.maxDistance = maxDistance;
            _isForDepths = false;
            minDepth = 0;
            _source.stop();
            _next = _end = _listBegin = _listEnd = 0;
            _waitingEnd = 0;
            push(0);
        }

        /**
         * Begins with pieces that stand, for depths behind planes. A triangle of the model counts with each listed triangle of the ground that it is behind the
         * plane of, because it may be deepest behind one that is wholly above it.
         */
        public function beginBehindPlanes():void
        {
            begin(RelativeMotion.NONE, 0);
            _isForDepths = true;
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

        /** Goes on to the next triangle near the piece: in its list, or if no list is around it, in the search. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (_next < _end)
            {
                triangle = _lists[_next];
                _next++;
            }
            else if (_listEnd == 0 && _source.next(_found[0]))
            {
                triangle = _found[0];
                triangle.setPlane();
            }
            else
            {
                return false;
            }
            // SquareSeparation may read the margin of any triangle: none is more than its slack
            piece.kernel.shape.margin = piece.shapeMargin + triangle.margin;
            return true;
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function nextPiece():Boolean
        {
            while (_waitingEnd > 0)
            {
                _waitingEnd -= 3;
                _listBegin = _waiting[int(_waitingEnd + 1)];
                _listEnd = _waiting[int(_waitingEnd + 2)];
                var node:int = _waiting[_waitingEnd];
                if (node < 0)
                {
                    piece.setToTriangle(-1 - node);
                }
                else
                {
                    piece.setToNode(node);
                }
                if (!findTriangles() || piece.kind != ModelPiece.INNER_NODE)
                {
                    return true;
                }
                divide(node);
            }
            return false;
        }

        // Divides the current piece, an inner node: the pieces inside of it come next, and its list is around them. The lower one of two nodes comes first,
        // because the ground is below.
        private function divide(node:int):void
        {
            var tree:BoxTree = piece.tree;
            var left:int = tree.left[node];
            _listBegin = _listEnd;
            _listEnd = _end;
            if (left > 0)
            {
                var lower:int = piece.heightOf(left) < piece.heightOf(left + 1) ? left : left + 1;
                push(left + left + 1 - lower);
                push(lower);
                return;
            }
            for (var i:int = tree.endPrimitive[node] - 1; i >= tree.firstPrimitive[node]; i--)
            {
                push(-1 - i);
            }
        }

        // Puts a node or a triangle before the pieces that come next, with the list around it.
        private function push(node:int):void
        {
            _waiting[_waitingEnd] = node;
            _waiting[int(_waitingEnd + 1)] = _listBegin;
            _waiting[int(_waitingEnd + 2)] = _listEnd;
            _waitingEnd += 3;
        }

        // Lists the triangles near the current piece. If no list is around it, begins to search for them, and lists them only near an inner node that comes to
        // few cells: each piece inside of a larger one has a search of its own. Returns false if surely none is near.
        private function findTriangles():Boolean
        {
            _next = _end = _listEnd;
            if (_listEnd > 0)
            {
                choose(_lists, _listBegin, _listEnd);
                return _end > _listEnd;
            }
            search.shape = piece.hasShapeInBox ? piece.kernel.shape : null;
            var comesToFewCells:Boolean = _source.begin(search);
            if (piece.kind != ModelPiece.INNER_NODE)
            {
                return true;
            }
            // of a larger one, one triangle tells enough
            while ((comesToFewCells || _end == 0) && findAt(_end))
            {
                choose(_found, _end, _end + 1);
            }
            var isNear:Boolean = _end > 0;
            _end = comesToFewCells ? _end : 0;
            return isNear;
        }

        // Finds the next triangle of the search. Returns false if there is none.
        private function findAt(index:int):Boolean
        {
            if (index == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            var found:GroundTriangle = _found[index];
            if (!_source.next(found))
            {
                return false;
            }
            found.setPlane();
            found.box.setToTriangle(found.corners);
            return true;
        }

        // Lists those of some triangles that the current piece comes near: the box around its motion meets the triangle's own box, and is not all in front of its
        // plane.
        private function choose(from:Vector.<GroundTriangle>, begin:int, end:int):void
        {
            var maxDistance:Number = search.maxDistance;
            var countsWhereverItIs:Boolean = _isForDepths && piece.kind == ModelPiece.TRIANGLE;
            var gap:Number = maxDistance + _source.path.slack;
            var around:GroundBox = piece.box;
            if (!search.motion.isStill)
            {
                _swept.copyFrom(around);
                _swept.extendAlong(search.motion);
                around = _swept;
            }
            var minX:Number = around.x - around.halfX;
            var minY:Number = around.y - around.halfY;
            var minZ:Number = around.z - around.halfZ;
            var maxX:Number = around.x + around.halfX;
            var maxY:Number = around.y + around.halfY;
            var maxZ:Number = around.z + around.halfZ;
            for (var i:int = begin; i < end; i++)
            {
                var near:GroundTriangle = from[i];
                var box:GroundBox = near.box;
                var normal:Vector3D = near.plane.normal;
                // the corner that is farthest behind the plane
                var x:Number = normal.x > 0 ? minX : maxX;
                var y:Number = normal.y > 0 ? minY : maxY;
                var z:Number = normal.z > 0 ? minZ : maxZ;
                // a flat triangle has no plane: then this is NaN, and the triangle counts
                var isInFront:Boolean = normal.x * x + normal.y * y + normal.z * z - near.plane.max > gap - minDepth;
                if (!isInFront && (countsWhereverItIs
                            || box.x - box.halfX - gap <= maxX && box.x + box.halfX + gap >= minX
                            && box.y - box.halfY - gap <= maxY && box.y + box.halfY + gap >= minY
                            && box.z - box.halfZ - gap <= maxZ && box.z + box.halfZ + gap >= minZ))
                {
                    _lists[_end] = near;
                    _end++;
                }
            }
        }

        /** Finds the ground under a point of the current piece. Returns whether the point is at least this deep under it. */
        public function hasPointUnder(depth:Number):Boolean
        {
            _under.x = piece.point.x + search.origin.x;
            _under.y = piece.point.y + search.origin.y;
            search.grid.findHeight(_under);
            return _under.height - depth >= piece.point.z + search.origin.z;
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
            if (!piece.hasShapeInBox)
            {
                return false;
            }
            var shape:ConvexShape = piece.kernel.shape;
            // hasPointUnder() has left there the ground under the piece's point
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
