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
     * <p>A GroundTriangles finds the triangles near the box of a piece, square by square. An inner node whose box comes to few cells keeps them in a list.
     * Each piece inside of it takes those near its own box from the list of the node around it, and if it is an inner node, lists these in turn.</p>
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

        // The triangles that the current search has found near an inner node, and then a place for the next one. Later searches use the same objects, so
        // frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _foundCount:int = 0;

        // The lists of the current inner node and of those around it, the outermost one's first.
        private var _lists:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();

        // The rest of the list that the current piece takes its triangles from. If there is no list, it ends at 0.
        private var _next:int = 0;
        private var _end:int = 0;

        // The box around the whole motion of the current piece.
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
            _next = _end = 0;
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
                _next = pieces.listBegin;
                _end = pieces.listEnd;
                setBox();
                if (pieces.kind != ModelPieces.INNER_NODE || !divideIfNear())
                {
                    return true;
                }
            }
            return false;
        }

        /** Goes on to the next triangle near the piece: in its list, or if it has none, in the search. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            var isNear:Boolean = _end == 0 && findNext();
            while (!isNear && _next < _end)
            {
                triangle = _lists[_next];
                _next++;
                isNear = isNearBox();
            }
            if (isNear)
            {
                // SquareSeparation may read the margin of any triangle: none is more than its slack
                pieces.kernel.shape.margin = pieces.shapeMargin + triangle.margin;
            }
            return isNear;
        }

        // Sets the box to that of the current piece. If the piece has no list, begins to search for the triangles near it.
        private function setBox():void
        {
            if (pieces.kind == ModelPieces.TRIANGLE)
            {
                _box.setToTriangle(pieces.corners);
                _box.halfX += pieces.shapeMargin;
                _box.halfY += pieces.shapeMargin;
                _box.halfZ += pieces.shapeMargin;
            }
            else
            {
                _box.copyFrom(pieces.box);
            }
            if (_end == 0)
            {
                search.box.copyFrom(_box);
                search.shape = pieces.hasShapeInBox ? pieces.kernel.shape : null;
                _source.begin(search);
                _foundCount = 0;
            }
            if (!search.motion.isStill)
            {
                _box.extendAlong(search.motion);
            }
        }

        // Divides the current piece, an inner node, if a triangle is near it. Returns whether there is one.
        private function divideIfNear():Boolean
        {
            // its list comes after the list of the node around it
            var begin:int = _end;
            var end:int = _end;
            if (!nextTriangle())
            {
                return false;
            }
            // without a list, each piece inside of it has a search of its own
            if (begin > 0 || _source.beginsAtCells())
            {
                do
                {
                    _lists[end] = triangle;
                    end++;
                }
                while (nextTriangle());
            }
            pieces.divide(begin, end);
            return true;
        }

        // Finds the next triangle of the search. For the smallest pieces all that it finds count: those of the cells under the box, at the box's heights.
        private function findNext():Boolean
        {
            if (_foundCount == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            triangle = _found[_foundCount];
            while (_source.next(triangle))
            {
                triangle.setPlane();
                if (pieces.kind != ModelPieces.INNER_NODE)
                {
                    return true;
                }
                triangle.box.setToTriangle(triangle.corners);
                if (isNearBox())
                {
                    _foundCount++;
                    return true;
                }
            }
            return false;
        }

        // Whether the current triangle is near the box: the box comes near the triangle's own box, and is not all in front of its plane. If the piece is a
        // triangle, only the plane counts, because the piece may be deepest behind a triangle of the ground whose box is wholly above its own.
        private function isNearBox():Boolean
        {
            var box:GroundBox = _box;
            var other:GroundBox = triangle.box;
            var gap:Number = search.maxDistance + _source.slack;
            var x:Number = box.x - other.x;
            var y:Number = box.y - other.y;
            var z:Number = box.z - other.z;
            var farX:Number = box.halfX + other.halfX + gap;
            var farY:Number = box.halfY + other.halfY + gap;
            var farZ:Number = box.halfZ + other.halfZ + gap;
            if (pieces.kind != ModelPieces.TRIANGLE && (z > farZ || z < -farZ || x > farX || x < -farX || y > farY || y < -farY))
            {
                return false;
            }
            // the corner of the box that is farthest behind the plane
            var normal:Vector3D = triangle.plane.normal;
            var cornerX:Number = normal.x > 0 ? box.x - box.halfX : box.x + box.halfX;
            var cornerY:Number = normal.y > 0 ? box.y - box.halfY : box.y + box.halfY;
            var cornerZ:Number = normal.z > 0 ? box.z - box.halfZ : box.z + box.halfZ;
            // a flat triangle has no plane: then this is NaN, and the triangle counts
            return !(normal.x * cornerX + normal.y * cornerY + normal.z * cornerZ - triangle.plane.max > gap - search.minDepth);
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
