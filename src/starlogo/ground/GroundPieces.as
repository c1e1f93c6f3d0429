package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.ConvexTrianglePair;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Goes through the convex pieces of a placed model, and for each piece through the triangles of the ground's surface near it. The model is
     * a structure or a tree.
     *
     * <p>A piece is a structure or a triangle. Nodes at the depth limit are pieces. Nodes that are divided only say, by their boxes, whether the
     * surface is near. If it is not, the node is a piece without triangles.</p>
     */
    internal final class GroundPieces
    {
        /** Tests the current piece and the triangle that <code>nextTriangle()</code> has found. Both are relative to the box's origin. */
        public var pair:ConvexTrianglePair = new ConvexTrianglePair();

        /** The box around the current piece or, for a triangle, around its node. Its limits may be narrowed. Its origin is the model's place. */
        public var box:GroundBox = new GroundBox();

        /** The ground. Read only. */
        public var grid:HeightGrid;

        private var _triangles:GroundTriangles = new GroundTriangles();

        private var _model:ModelTree;
        private var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;

        // The model's placement at the current time. Its position is relative to the box's origin.
        private var _relative:Placement = new Placement();

        // What is still to be visited: whether the structure is; the nodes, and their number; and the triangles of the last node, a range.
        private var _isWhole:Boolean = false;
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodeCount:int = 0;
        private var _first:int = 0;
        private var _end:int = 0;

        // A point of the current piece, and the ground there.
        private var _point:Vector3D = new Vector3D();
        private var _ground:GroundPoint = new GroundPoint();

        // The margin of the model's place and surface, and that of the piece without that of a triangle.
        private var _margin:Number = 0;
        private var _pieceMargin:Number = 0;

        private var _node:Box = BoxTree.newBox();
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /** Sets the model and the ground, as <code>GroundQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, model:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            this.grid = grid;
            _model = model;
            _structure = structure;
            _relative.copyFrom(placement);
            box.origin.x = placement.x;
            box.origin.y = placement.y;
            box.origin.z = placement.z;
            _isExact = model != null && exact && model.hasTriangles;
            _depth = _isExact ? BoxTree.NO_LIMIT : depth;
            // The margin is as large as if another agent stood at the place of the touch.
            _margin = 2 * Touching.marginOfPlace(placement.x, placement.y, placement.z);
            if (_isExact)
            {
                _margin += Touching.marginOfSurface(model.boxTree.radius * placement.size);
            }
            placeAt(RelativeMotion.NONE, 0);
        }

        /** The triangle that <code>nextTriangle()</code> has found. Read only. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
        }

        /** Whether the model is a tree; otherwise it is a structure. */
        public function get hasTree():Boolean
        {
            return _model != null;
        }

        /** Moves the model to where the motion has brought it at a time. */
        public function placeAt(motion:RelativeMotion, time:Number):void
        {
            _relative.x = motion.startX + time * motion.x;
            _relative.y = motion.startY + time * motion.y;
            _relative.z = motion.startZ + time * motion.z;
        }

        /**
         * Begins with all pieces.
         *
         * @param motion of the pieces: triangles that they may meet count
         * @param maxDistance triangles count that are at most this far away
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            reset(motion, maxDistance);
            if (hasTree)
            {
                addNode(0);
            }
            else
            {
                _isWhole = true;
            }
        }

        /** Begins with the structure around all pieces as the only one. */
        public function beginWhole(motion:RelativeMotion, maxDistance:Number):void
        {
            reset(motion, maxDistance);
            _isWhole = true;
        }

        /**
         * Begins with the structure around all pieces as the only one, and with the triangles at a point of the ground. The piece is set: go on with
         * <code>nextTriangle()</code>.
         */
        public function beginAt(at:GroundPoint):void
        {
            reset(RelativeMotion.NONE, 0);
            setPiece(_structure);
            box.x = at.x - box.origin.x;
            box.y = at.y - box.origin.y;
            box.z = at.height - box.origin.z;
            box.halfX = box.halfY = box.halfZ = 0;
            box.shape = null;
            _triangles.begin(grid, box);
        }

        /**
         * Goes on to the next piece. Returns false if there is none. The piece may be a node that no triangle is near: then only its middle is known, and
         * the pair has no shape of it.
         */
        public function nextPiece():Boolean
        {
            while (_first == _end)
            {
                if (_isWhole)
                {
                    _isWhole = false;
                    beginPiece(_structure);
                    return true;
                }
                if (_nodeCount == 0)
                {
                    return false;
                }
                _nodeCount--;
                if (visit(_nodes[_nodeCount]))
                {
                    return true;
                }
            }
            pair.setShapeToTriangle(_model.prepareCorners(), 9 * _first, _relative);
            _first++;
            finishPiece();
            _triangles.begin(grid, box);
            return true;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (!_triangles.next())
            {
                return false;
            }
            pair.shape.margin = _pieceMargin + triangle.margin;
            pair.setTriangle(triangle.corners, 0);
            return true;
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            _ground.x = _point.x + box.origin.x;
            _ground.y = _point.y + box.origin.y;
            grid.findHeight(_ground);
            return _ground.height - depth >= _point.z + box.origin.z;
        }

        /** Puts the box around the whole model. */
        public function placeBox():void
        {
            placeAround(_structure);
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += box.origin.x;
            contact.y += box.origin.y;
            contact.z += box.origin.z;
        }

        // Begins without a piece.
        private function reset(motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            _nodeCount = _first = _end = 0;
            _isWhole = false;
            box.motion = motion;
            box.latest = 1;
            box.maxDistance = maxDistance;
            box.above = -Infinity;
        }

        private function addNode(node:int):void
        {
            _nodes[_nodeCount] = node;
            _nodeCount++;
        }

        // Begins with a node. Returns whether it is a piece.
        private function visit(node:int):Boolean
        {
            var tree:BoxTree = _model.boxTree;
            var isDivided:Boolean = tree.stop[node] < _depth;
            tree.writeBox(node, _node);
            if (!isDivided && !_isExact)
            {
                beginPiece(_node);
                return true;
            }
            box.shape = null;
            placeAround(_node);
            if (!isDivided)
            {
                _first = tree.first[node];
                _end = tree.end[node];
                return false;
            }
            _triangles.begin(grid, box);
            if (!_triangles.next())
            {
                _point.setTo(box.x, box.y, box.z);
                return true;
            }
            _triangles.stop();
            addNode(tree.left[node] + 1);
            addNode(tree.left[node]);
            return false;
        }

        private function beginPiece(structure:BoundingStructure):void
        {
            setPiece(structure);
            placeAround(structure);
            box.shape = pair.shape;
            _triangles.begin(grid, box);
        }

        private function setPiece(structure:BoundingStructure):void
        {
            pair.setStructure(structure, _relative);
            finishPiece();
        }

        private function finishPiece():void
        {
            _pieceMargin = pair.shape.margin + _margin;
            _point.x = pair.shape.x;
            _point.y = pair.shape.y;
            _point.z = pair.shape.z;
        }

        // Puts the box around a structure of the model.
        private function placeAround(structure:BoundingStructure):void
        {
            structure.rotatedBoxInto(_relative, _extents);
            box.x = _extents[0] + _relative.x;
            box.y = _extents[1] + _relative.y;
            box.z = _extents[2] + _relative.z;
            box.halfX = _extents[3] + _margin;
            box.halfY = _extents[4] + _margin;
            box.halfZ = _extents[5] + _margin;
        }
    }
}
